// The generated code is short: the value and its derivatives share sines and cosines.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, compileWarp, gen } from '../../dist/warpjet.js'
import { methods } from '../../web/bench/methods.js'
import { workloads } from '../../web/bench/workloads.js'
import { warps } from '../warps/index.js'
import { stackedSines } from '../warps/stress.js'

const countCalls = (text, name) => text.match(new RegExp(`\\b${name}\\(`, 'g'))?.length ?? 0

/** Counts the components of all arguments with which a function is called: 3 for a vec3 `v`, 2 for `v.xy`. */
const countComponents = (text, name) => {
  let count = 0
  for (const [, variable, components] of text.matchAll(
    new RegExp(`\\b${name}\\((\\w+)?(?:\\.(\\w+)\\))?`, 'g'),
  ))
    count += components?.length ?? Number(text.match(`vec(\\d) ${variable} = `)?.[1] ?? 1)
  return count
}

test('a twist has one sine and one cosine', () => {
  const { code } = warps.find(({ name }) => name === 'twist').compile()
  assert.deepEqual([countCalls(code, 'sin'), countCalls(code, 'cos')], [1, 1])
})

for (const count of [1, 30, 300])
  test(`${count} stacked sines have at most ${count} sines and ${count} cosines`, () => {
    const { code } = compileWarp(stackedSines(count).warp)
    assert.ok(countCalls(code, 'sin') <= count)
    assert.ok(countCalls(code, 'cos') <= count)
  })

test('300 stacked sines, 1,500 operations, are at most 40,000 characters', () => {
  const { code } = compileWarp(stackedSines(300).warp)
  assert.ok(code.length <= 40_000, `${code.length} characters`)
})

for (const workload of workloads)
  test(`${workload.name}: the code is not much longer than code written by hand`, () => {
    const length = (name) => {
      const { declarations = '', body } = methods
        .find((method) => method.name === name)
        .program(workload)
      return declarations.length + body.length
    }
    const ratio = length('warpjet') / length('by hand')
    assert.ok(ratio <= 1.1, `${ratio} times the characters`)
  })

test('the normal of a rotation has no square of a sine or a cosine', () => {
  for (const turn of ['rotateX', 'rotateY', 'rotateZ']) {
    const { code } = compileWarp(({ glsl, position }) =>
      glsl[turn](position.y().mult(glsl.param('angle')).add(1))
        .mult(position)
        .sub(position),
    )
    const names = [...code.matchAll(/(\w+) = (?:sin|cos)\(/g)].map(([, name]) => name)
    assert.equal(names.length, 2, code)
    for (const name of names) assert.ok(!code.includes(`${name} * ${name}`), code)
  }
})

test('a cross product in an offset is written as cross', () => {
  const { code } = compileWarp(
    ({ glsl, position }) => glsl.cross(position, glsl.vec3Param('axis')),
    {
      normals: false,
    },
  )
  assert.match(code, /offset = cross\(position, axis\);/)
})

test('a matrix that rotates several points has one variable in each body that reads it', () => {
  const { code } = compile((glsl) => {
    const [angle, x, y] = ['angle', 'x', 'y'].map((name) => glsl.param(name))
    const turn = (by, [a, b]) => [
      a.mult(by.cos()).sub(b.mult(by.sin())),
      a.mult(by.sin()).add(b.mult(by.cos())),
    ]
    const twice = (point) => turn(angle, turn(angle, point))
    const state = glsl.repeat(3, glsl.vec2(x, y), (s) =>
      glsl.vec2(...twice(turn(s.x(), [s.x(), s.y()]))),
    )
    const [a, b] = twice([state.x(), state.y()])
    return { z: glsl.vec3(a.mult(a), b.mult(b), 1) }
  })
  const body = code.slice(code.indexOf('for ('), code.indexOf('  }\n'))
  for (const text of [body, code.replace(body, '')]) {
    const name = text.match(/mat2 (\w+) = mat2\(t0, t1, -t1, t0\)/)?.[1]
    assert.equal(text.split(` = ${name} * `).length - 1, 2, code)
  }
})

test('stats count vector operations', () => {
  const { stats, code } = compileWarp(nestedSines(8, 'xyz'))
  assert.equal(stats.vectors, code.match(/^ *vec\d t\d+ =/gm).length)
  assert.equal(stats.temporaries, code.match(/^ *(vec\d|float|bool) t\d+ =/gm).length)
})

test('code for positions only has no derivatives', () => {
  const { code } = compileWarp(stackedSines(30).warp, { normals: false })
  assert.equal(countCalls(code, 'cos'), 0)
  assert.doesNotMatch(code, /normal/i)
})

test('the wobble warp has at most 9 sines and 6 cosines', () => {
  const { code } = warps.find(({ name }) => name === 'wobble').compile()
  assert.ok(countCalls(code, 'sin') <= 9, `${countCalls(code, 'sin')} sines`)
  assert.ok(countCalls(code, 'cos') <= 6, `${countCalls(code, 'cos')} cosines`)
})

/** Returns nested sines in each component; `axes` names the coordinate for each. */
const nestedSines =
  (depth, axes) =>
  ({ glsl, position }) => {
    const chain = (axis) => {
      let value = position[axis]()
      for (let i = 0; i < depth; i++) value = value.mult(1.1).add(0.3).sin()
      return value
    }
    return glsl.vec3(...[...axes].map(chain))
  }

/** Warps the position with a function of itself, `depth` times, so that every component depends on every coordinate. */
const nestedWarps =
  (depth) =>
  ({ position }) => {
    let place = position
    for (let i = 0; i < depth; i++) place = place.add(place.yzx()).sin()
    return place
  }

for (const [axes, chains] of Object.entries({ xxx: 1, xxy: 2, xyz: 3 }))
  test(`${chains} different chains of 24 nested sines have 24 sines and 24 cosines each`, () => {
    const { code } = compileWarp(nestedSines(24, axes))
    assert.deepEqual(
      [countComponents(code, 'sin'), countComponents(code, 'cos')],
      [24 * chains, 24 * chains],
    )
  })

test('warps nested 24 deep have 24 sines and 24 cosines for each component', () => {
  const { code } = compileWarp(nestedWarps(24))
  assert.deepEqual([countComponents(code, 'sin'), countComponents(code, 'cos')], [72, 72])
  assert.deepEqual([countCalls(code, 'sin'), countCalls(code, 'cos')], [24, 24])
})

for (const [name, nested] of Object.entries({
  sines: (depth) => nestedSines(depth, 'xyz'),
  warps: nestedWarps,
}))
  test(`the code of nested ${name} grows linearly with their depth`, () => {
    const size = (depth) => compileWarp(nested(depth)).code.length
    for (const depth of [12, 24, 48]) {
      const [first, second] = [size(2 * depth) - size(depth), size(4 * depth) - size(2 * depth)]
      // `second` is for twice as many levels; the numbers in names are longer, too.
      assert.ok(
        second <= 1.1 * 2 * first,
        `${first} characters for ${depth} levels, then ${second}`,
      )
    }
  })

test('a square is one multiplication', () => {
  for (const square of [(x) => x.pow(2), (x, glsl) => glsl.pow(x, 2), (x) => x.mult(x)]) {
    const { code, stats } = compile((glsl) => ({ y: square(glsl.param('x'), glsl) }))
    assert.match(code, /y = x \* x;/)
    assert.equal(stats.operations, 1)
  }
  const { code, stats } = compile((glsl) => ({ y: glsl.param('x').sin().pow(2) }))
  assert.equal(stats.operations, 2)
  assert.equal(countCalls(code, 'sin'), 1)
})

test('a warp that does not depend on x has no column for x', () => {
  // Returns an offset. Each component is a sum of sines, one for each coordinate in `axes`; all sines are different.
  const sinesOf = (axes) => (glsl, position) => {
    const component = (i) =>
      axes.map((axis, k) =>
        position[axis]()
          .mult(2 + axes.length * i + k)
          .sin(),
      )
    return glsl.vec3(...[0, 1, 2].map((i) => glsl.sum(...component(i))))
  }
  const count = (axes) => {
    const { code } = compileWarp(({ glsl, position }) => sinesOf(axes)(glsl, position))
    const reads = (name) => code.split(name).length - 1
    const normal = ['x', 'y', 'z'].map((axis) => reads(`normal.${axis}`))
    return { derivatives: countComponents(code, 'cos'), x: reads('position.x') > 0, normal }
  }
  assert.deepEqual(count(['x', 'y', 'z']), { derivatives: 9, x: true, normal: [1, 1, 1] })
  // The first column of I + J is (1, 0, 0), so that the new x of the normal does not depend on its y and z.
  assert.deepEqual(count(['y', 'z']), { derivatives: 6, x: false, normal: [3, 2, 2] })

  const code = gen((ad) => {
    const position = ad.vec3Param('position')
    sinesOf(['y', 'z'])(ad, position).outputDeriv('byX', position.x())
  })
  assert.match(code, /^vec3 byX;\s*\{\s*byX = vec3\(0\.0\);\s*\}\s*$/)
})

/** Returns each component of the wobble's offset and of its derivatives, by name. */
function wobbleByComponent(glsl) {
  const { warp } = warps.find(({ name }) => name === 'wobble')
  const position = glsl.vec3Param('position')
  const offset = warp({ glsl, position, millis: glsl.param('millis') })
  const results = {}
  for (const row of ['x', 'y', 'z']) {
    results[row] = offset[row]()
    for (const column of ['x', 'y', 'z'])
      results[`${row}By${column}`] = glsl.derivative(offset[row](), position[column]())
  }
  return results
}

/** Returns the assignments of the wobble's code. Those to temporaries start with a type; results are declared before the code. */
function wobbleLines(maxDepthPerVariable) {
  const write = (ad) => {
    for (const [name, result] of Object.entries(wobbleByComponent(ad))) result.output(name)
  }
  const text = gen(write, { maxDepthPerVariable })
  const lines = text.matchAll(/^ *(?:(float|bool)|vec2)? ?(\w+) = (.*);$/gm)
  return [...lines].map(([, type, name, value]) => ({ isTemporary: !!type, name, value }))
}

test('maxDepthPerVariable 1 writes one operation per line', () => {
  const operation = /\w\(| [-+*/?<>] |\|\||^-[a-z]/g
  const counts = wobbleLines(1).map(({ value }) => value.match(operation)?.length ?? 0)
  // Results that are constant need no operation.
  assert.deepEqual([...new Set(counts)].sort(), [0, 1])
  assert.equal(counts.filter(Boolean).length, compile(wobbleByComponent).stats.operations)
})

test('maxDepthPerVariable Infinity makes temporaries only for values that are read twice, or selected by a condition', () => {
  const lines = wobbleLines(Infinity)
  const words = lines.flatMap(({ value }) => value.match(/\w+/g))
  const selected = lines.flatMap(({ value }) => value.match(/(?<=[?:] )\w+/g) ?? [])
  for (const { name } of lines.filter(({ isTemporary }) => isTemporary))
    assert.ok(
      selected.includes(name) || words.filter((word) => word === name).length > 1,
      `${name} is read only once`,
    )
})
