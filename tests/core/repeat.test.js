// Tests glsl.repeat: compares values and derivatives on the CPU with plain loops and finite differences in double precision; checks shader
// code, bounds and errors.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile, compileWarp, targets } from '../../dist/warpjet.js'
import { foldCallback, foldNumber, randomFoldCase, secondSlope, slopes } from '../random/folds.js'
import { throwsWarpError } from '../support/warp-errors.js'

const assertNear = (got, expected, tolerance, message) =>
  assert.ok(
    Math.abs(got - expected) <= tolerance * Math.max(1, Math.abs(expected)),
    message ?? `${got}, not ${expected}`,
  )

describe('glsl.repeat returns values', () => {
  test('of a number, and passes the index of the step', () => {
    const { evaluate } = compile((glsl) => ({
      sum: glsl.repeat(5, 0, (sum, i) => sum.add(i.mult(glsl.param('x')))),
    }))
    assert.deepEqual(evaluate({ x: 3 }), { sum: 30 })
  })

  test('of a vector', () => {
    const { evaluate } = compile((glsl) => {
      const c = glsl.vec2Param('c')
      const square = (z) =>
        glsl.vec2(z.x().mult(z.x()).sub(z.y().mult(z.y())), z.x().mult(z.y(), 2))
      return { z: glsl.repeat(3, c, (z) => square(z).add(c)) }
    })
    let [x, y] = [0.2, 0.3]
    for (let i = 0; i < 3; i++) [x, y] = [x * x - y * y + 0.2, 2 * x * y + 0.3]
    const { z } = evaluate({ c: [0.2, 0.3] })
    assertNear(z[0], x, 1e-12)
    assertNear(z[1], y, 1e-12)
  })

  test('of a record, whose parts change together', () => {
    const { evaluate } = compile((glsl) => {
      const { a, b } = glsl.repeat(10, { a: 0, b: 1 }, ({ a, b }) => ({ b: a.add(b), a: b }))
      return { fibonacci: a.add(b.mult(1000)), same: glsl.repeat(4, { a }, ({ a }) => ({ a })).a }
    })
    assert.deepEqual(evaluate({}), { fibonacci: 55 + 89 * 1000, same: 55 })
  })

  test('equal to the start if there are no steps', () => {
    const { evaluate } = compile((glsl) => ({
      x: glsl.repeat(0, 7, (x) => x.mult(glsl.param('y'))),
    }))
    assert.deepEqual(evaluate({ y: 3 }), { x: 7 })
  })

  test('and derivatives equal to those of 200 random JavaScript loops', () => {
    const compared = { value: 0, slope: 0, second: 0 }
    for (let seed = 0; seed < 200; seed++) {
      const fold = randomFoldCase(seed)
      const { evaluate } = compile(foldCallback(fold))
      const [x, y, z] = fold.point
      const got = evaluate({ x, y, z })
      assertNear(got[`value${seed}`], foldNumber(fold, fold.point), 1e-9, `value of ${seed}`)
      compared.value++
      for (const [i, { value, isFirm }] of slopes(fold, fold.point).entries()) {
        if (!isFirm) continue
        assertNear(
          got[`slope${seed}`][i],
          value,
          1e-4,
          `slope ${i} of ${seed}: ${got[`slope${seed}`][i]} for ${value}`,
        )
        compared.slope++
      }
      const second = secondSlope(fold, fold.point)
      if (!second.isFirm) continue
      assertNear(
        got[`second${seed}`],
        second.value,
        5e-3,
        `second of ${seed}: ${got[`second${seed}`]} for ${second.value}`,
      )
      compared.second++
    }
    assert.ok(compared.slope > 540 && compared.second > 150, JSON.stringify(compared))
  })
})

test('on the CPU, a warp with repeat transforms normals like the same warp with the loop unrolled by JavaScript', () => {
  const offset =
    (repeat) =>
    ({ glsl, position }) =>
      repeat(glsl, 6, position, (p, i) => p.add(p.zxy().mult(2).add(i).sin().mult(0.1))).sub(
        position,
      )
  const unroll = (glsl, count, start, body) => {
    let state = start
    for (let i = 0; i < count; i++) state = body(state, glsl.val(i))
    return state
  }
  const mesh = { positions: [0.3, -0.2, 0.7, 1, 2, 3], normals: [0, 0, 1, 0.6, 0.8, 0] }
  const [loop, unrolled] = [offset((glsl, ...args) => glsl.repeat(...args)), offset(unroll)].map(
    (warp) => compileWarp(warp).evaluate(mesh),
  )
  for (const key of ['positions', 'normals'])
    loop[key].forEach((value, i) => assertNear(value, unrolled[key][i], 2e-6))
})

describe('shader code', () => {
  const chain = ({ glsl, position }) =>
    glsl.repeat(24, position, (p) => p.zxy().mult(1.1).sin()).sub(position)

  for (const target of targets)
    test(`is one loop for value and derivatives in ${target}`, () => {
      const { code } = compileWarp(chain, { target })
      assert.equal(code.split('for (').length - 1, 1)
      assert.ok(code.length < 3000, String(code.length))
    })

  test('computes loop invariants once', () => {
    const { code } = compile((glsl) => {
      const x = glsl.param('x')
      return { y: glsl.repeat(9, 0, (sum) => sum.add(x.sin().exp())) }
    })
    assert.ok(code.indexOf('sin(x)') < code.indexOf('for ('), code)
  })

  test('has no unused state', () => {
    const { code } = compile((glsl) => ({
      y: glsl.repeat(9, { a: 0, b: glsl.param('b') }, ({ a, b }) => ({ a: a.add(1), b: b.sin() }))
        .a,
    }))
    assert.doesNotMatch(code, /sin/)
  })
})

test('bounds contain the results of the loop', () => {
  const warp = compileWarp(({ glsl, position }) =>
    glsl.vec3(
      0,
      glsl.repeat(4, position.x(), (s, i) => s.mult(2).add(i).sin()),
      0,
    ),
  )
  const { min, max } = warp.bounds({ min: [-1, 0, 0], max: [1, 0, 0] })
  for (let x = -1; x <= 1; x += 0.01) {
    let s = x
    for (let i = 0; i < 4; i++) s = Math.sin(2 * s + i)
    assert.ok(min[1] <= s && s <= max[1], `${s} outside of ${min[1]} to ${max[1]}`)
  }
  assert.ok(max[1] - min[1] < 2.2)
})

describe('rejects', () => {
  const compileWith = (build) => () => compile((glsl) => ({ r: build(glsl, glsl.param('x')) }))
  const cases = {
    'an expression as the count': [
      (g, x) => g.repeat(x, 0, (s) => s),
      /argument 1 is an expression.*ifElse/,
    ],
    'a fractional count': [
      (g) => g.repeat(2.5, 0, (s) => s),
      /expected a whole number from 0 to 2147483647 for argument 1, got the number 2\.5/,
    ],
    'a negative count': [
      (g) => g.repeat(-1, 0, (s) => s),
      /expected a whole number from 0 to .* for argument 1, got the number -1/,
    ],
    'a missing count': [
      (g) => g.repeat(undefined, 0, (s) => s),
      /expected a whole number .* for argument 1, got undefined/,
    ],
    'too many steps': [(g) => g.repeat(20000, 0, (s) => s), /at most 10000 steps/],
    'too many steps in nested loops': [
      (g) => g.repeat(200, 0, (s) => g.repeat(200, s, (t) => t.add(1))),
      /at most 10000 steps.*multiplied.*40000/,
    ],
    'loops nested too deeply': [
      (g) => {
        const nest = (s, levels) => (levels ? g.repeat(2, s, (t) => nest(t, levels - 1)) : s.add(1))
        return nest(g.val(0), 9)
      },
      /at most 8 deep/,
    ],
    'a missing initial state': [
      (g) => g.repeat(2, undefined, (s) => s),
      /expected a number or an expression for the start of the state/,
    ],
    'an empty initial state': [(g) => g.repeat(2, {}, (s) => s), /empty object/],
    'an array as the initial state': [(g) => g.repeat(2, [1, 2], (s) => s), /glsl\.vec3/],
    'a missing body': [
      (g) => g.repeat(2, 0, 1),
      /expected a function \(state, i\) => … for argument 3, got the number 1/,
    ],
    'a fourth argument': [(g) => g.repeat(2, 0, (s) => s, 5), /the number 5 is too many/],
    'a body that returns nothing': [
      (g) => g.repeat(2, 0, () => {}),
      /returns nothing; put a return/,
    ],
    'a body that returns a promise': [
      (g) => g.repeat(2, 0, async (s) => s),
      /promise|must return one state/,
    ],
    'a new state of another shape': [
      (g) => g.repeat(2, 0, () => g.vec3(1, 2, 3)),
      /the state starts as a single number, but the function returns a vec3 for it; start with a vec3/,
    ],
    'a new state of another shape in a record': [
      (g) => g.repeat(2, { p: g.vec3(1), t: 0 }, ({ t }) => ({ p: t, t })).t,
      /"p" starts as a vec3, but the function returns a single number for it/,
    ],
    'a new state without one of the parts': [
      (g) => g.repeat(2, { a: 0, b: 0 }, ({ a }) => ({ a })).a,
      /must return "b" too/,
    ],
    'a new state with an additional part': [
      (g) => g.repeat(2, { a: 0 }, ({ a }) => ({ a, c: a })).a,
      /returns "c", but the start has a/,
    ],
    'a single new state instead of a record': [
      (g) => g.repeat(2, { a: 0 }, ({ a }) => a).a,
      /object with a/,
    ],
    'a state used outside its body': [
      (g) => {
        let leaked
        g.repeat(2, 0, (s) => (leaked = s))
        return leaked
      },
      /can be used only in its function; use the result of repeat/,
    ],
    'a step number used outside its body': [
      (g) => {
        let leaked
        g.repeat(2, 0, (s, i) => ((leaked = i), s.add(i)))
        return leaked.add(1)
      },
      /can be used only in its function/,
    ],
    'a derivative of a state': [
      (g, x) => g.repeat(2, x, (s) => s.add(g.derivative(s.mult(x), x))),
      /derivative: .*only after its end/,
    ],
  }
  for (const [name, [build, pattern]] of Object.entries(cases))
    test(name, () => throwsWarpError(compileWith(build), pattern))

  test('an expression of another warp as a state', () => {
    let foreign
    compile((glsl) => ({ r: (foreign = glsl.param('x')) }))
    throwsWarpError(
      compileWith((g) => g.repeat(2, foreign, (s) => s)),
      /another warp/,
    )
    throwsWarpError(
      compileWith((g) => g.repeat(2, 0, () => foreign)),
      /another warp/,
    )
  })

  test('and works again after an error that the user catches', () => {
    const { evaluate } = compile((glsl) => {
      assert.throws(
        () =>
          glsl.repeat(3, 0, () => {
            throw new Error('mine')
          }),
        /mine/,
      )
      return { r: glsl.repeat(3, 0, (s) => s.add(2)) }
    })
    assert.deepEqual(evaluate({}), { r: 6 })
  })
})

test('an expression of a body that does not depend on the state can be differentiated with respect to an input', () => {
  const { evaluate } = compile((glsl) => {
    const x = glsl.param('x')
    return { r: glsl.repeat(3, 0, (s, i) => s.add(glsl.derivative(x.mult(i).sin(), x))) }
  })
  assertNear(evaluate({ x: 0.4 }).r, Math.cos(0.4) + 2 * Math.cos(0.8), 1e-12)
})

test('the body can call a function of the host, whose derivatives are used', () => {
  const { code, declarations } = compile((glsl) => {
    const x = glsl.param('x')
    const bump = glsl.fn({
      name: 'bump',
      arity: 1,
      source: 'float bump(float x) { return x * x; }',
      derivatives: [(a) => a.mult(2)],
    })
    const y = glsl.repeat(3, x, (s) => bump(s).mult(0.5))
    return { y, slope: glsl.derivative(y, x) }
  })
  assert.match(declarations, /bump/)
  assert.equal(code.split('for (').length - 1, 1)
})
