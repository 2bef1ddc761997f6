// Tests chain, add, blend and mask: positions and normals equal those of the same composition of plain functions. `twisted`, `bent` and
// `waved` are pairs of a warp and the same offset as a plain function.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { add, blend, chain, inSpace, inflate, mask, wave } from '../../dist/deformers.js'
import { compileWarp } from '../../dist/warpjet.js'
import { columnMajor, dot, add as plus, rotation, subtract } from '../support/browser/matrix.js'
import {
  after,
  agree,
  assertClose,
  bent,
  inDouble,
  normalAfter,
  times,
  twisted,
  vertices,
  waved,
} from '../support/compositions.js'
import { throwsWarpError } from '../support/warp-errors.js'

describe('chain', () => {
  test('applies the second warp after the first', () => {
    agree(chain(twisted[0], bent[0]), after(twisted[1], bent[1]))
    agree(chain(bent[0], twisted[0]), after(bent[1], twisted[1]))
    agree(chain(waved[0], twisted[0], bent[0]), after(after(waved[1], twisted[1]), bent[1]))
  })

  test('equals the warp if there is only one, and can be nested', () => {
    agree(chain(twisted[0]), twisted[1])
    const expected = after(waved[1], after(twisted[1], bent[1]))
    agree(chain(waved[0], chain(twisted[0], bent[0])), expected)
    agree(chain(chain(waved[0], twisted[0]), bent[0]), expected)
  })

  test('depends on the order', () => {
    const at = (warp) =>
      inDouble(warp)({ position: [50, 60, 20], normal: [0, 0, 1], millis: 0 }).offset
    const [one, other] = [chain(twisted[0], waved[0]), chain(waved[0], twisted[0])].map(at)
    assert.ok(Math.hypot(...subtract(one, other)) > 1)
  })

  test('passes the warped normal of the previous warps, normalized', () => {
    for (const [warp, oracle] of [
      [chain(twisted[0], inflate({ amount: 10 })), twisted[1]],
      [chain(waved[0], chain(twisted[0], inflate({ amount: 10 }))), after(waved[1], twisted[1])],
      [chain(chain(waved[0], twisted[0]), inflate({ amount: 10 })), after(waved[1], twisted[1])],
      [chain(waved[0], add(twisted[0], inflate({ amount: 10 }))), null],
    ]) {
      const evaluate = inDouble(warp)
      for (const vertex of vertices) {
        const { offset } = evaluate(vertex)
        const p = vertex.position
        const expected = oracle
          ? plus(oracle(p, vertex), times(normalAfter(oracle, p, vertex), 10))
          : plus(
              after(waved[1], twisted[1])(p, vertex),
              times(normalAfter(waved[1], p, vertex), 10),
            )
        assertClose(offset, expected, 1e-6)
      }
    }
  })

  test('moves along a warped normal, including the derivative of the normal', () => {
    // By hand: on the plane y = 0, sheared by x² / 200, the normal is (-x / 100, 1, 0) / √(1 + x² / 10⁴).
    const hill = ({ glsl, position }) => glsl.vec3(0, position.x().pow(2).div(200), 0)
    const evaluate = inDouble(chain(hill, inflate({ amount: 30 })))
    for (const x of [-80, 0, 30]) {
      const slope = x / 100
      const length = Math.hypot(1, slope)
      const { offset, derivatives, warpedNormal } = evaluate({
        position: [x, 0, 7],
        normal: [0, 1, 0],
        millis: 0,
      })
      assertClose(offset, [(-30 * slope) / length, x ** 2 / 200 + 30 / length, 0], 1e-9)
      // The derivatives of these offsets with respect to x. A parallel surface has the same normals as the original.
      const byX = [-0.3 / length ** 3, slope - (0.3 * slope) / length ** 3, 0]
      assertClose(derivatives.slice(0, 3), byX, 1e-9)
      assertClose(warpedNormal, [-slope / length, 1 / length, 0], 1e-9)
    }
  })

  test('computes no unused normal', () => {
    const matrix = columnMajor(rotation(0.8, 0, 1))
    const warp = chain(
      waved[0],
      inSpace(matrix, chain(twisted[0], bent[0])),
      blend(twisted[0], bent[0]),
    )
    const noNormals = (glsl) => ({
      ...glsl,
      adjustNormal: () => assert.fail('a normal was computed'),
    })
    compileWarp((inputs) => warp({ ...inputs, glsl: noNormals(inputs.glsl) }))
    assert.throws(
      () =>
        compileWarp((inputs) =>
          chain(warp, inflate())({ ...inputs, glsl: noNormals(inputs.glsl) }),
        ),
      /a normal was computed/,
    )
  })

  test('computes each sine and cosine only once', () => {
    const text = compileWarp(chain(twisted[0], bent[0], waved[0])).code
    const count = (name) => text.match(new RegExp(`\\b${name}\\(`, 'g')).length
    assert.deepEqual([count('sin'), count('cos')], [3, 3])
    const { stats } = compileWarp(chain(twisted[0], twisted[0]))
    assert.ok(stats.operations < 250, `${stats.operations} operations`)
  })

  test('compiles to code whose length is linear in the number of warps', () => {
    const size = (count) => compileWarp(chain(...Array(count).fill(twisted[0]))).stats.operations
    const [two, four, eight] = [2, 4, 8].map(size)
    assert.ok(eight - four < 2.2 * (four - two), `${two} ${four} ${eight}`)
  })

  test('throws for a derivative with respect to a moved position', () => {
    const slope = ({ glsl, position }) => glsl.derivative(position.yzx(), position.x())
    assert.equal(typeof compileWarp(slope).code, 'string')
    assert.equal(typeof compileWarp(chain(slope, twisted[0])).code, 'string')
    throwsWarpError(
      () => compileWarp(chain(twisted[0], slope)),
      /^derivative: argument 2 must be an input/,
    )
  })
})

describe('add', () => {
  test('is the sum of the offsets, in any order', () => {
    const sum = (p, inputs) =>
      plus(twisted[1](p, inputs), plus(bent[1](p, inputs), waved[1](p, inputs)))
    agree(add(twisted[0], bent[0], waved[0]), sum)
    agree(add(waved[0], twisted[0], bent[0]), sum)
    agree(add(waved[0]), waved[1])
  })

  test('shares common parts of its warps', () => {
    const { code } = compileWarp(add(waved[0], waved[0], wave({ amount: 7 })))
    assert.equal(code.match(/\bsin\(/g).length, 1)
  })
})

describe('blend', () => {
  const between = (amount) => (p, inputs) => {
    const [a, b, t] = [twisted[1](p, inputs), bent[1](p, inputs), amount(p)]
    return a.map((x, i) => x + (b[i] - x) * t)
  }

  test('interpolates from one warp to the other', () => {
    agree(
      blend(twisted[0], bent[0]),
      between(() => 0.5),
    )
    agree(blend(twisted[0], bent[0], 0), twisted[1])
    agree(blend(twisted[0], bent[0], 1), bent[1])
    agree(
      blend(twisted[0], bent[0], ({ glsl }) => glsl.param('t')),
      between(() => 0.3),
      { t: 0.3 },
    )
  })

  test('accepts an amount that varies over the shape', () => {
    const amount = ({ position }) => position.x().mult(0.02).sin()
    agree(
      blend(twisted[0], bent[0], amount),
      between(([x]) => Math.sin(0.02 * x)),
    )
    agree(
      (inputs) => blend(twisted[0], bent[0], amount(inputs))(inputs),
      between(([x]) => Math.sin(0.02 * x)),
    )
  })
})

test('mask multiplies a warp by a weight, and accounts for the derivative of the weight', () => {
  agree(mask(twisted[0], 0.25), (p, inputs) => times(twisted[1](p, inputs), 0.25))
  agree(
    mask(twisted[0], ({ glsl }) => glsl.param('w')),
    (p, i) => times(twisted[1](p, i), i.w),
    { w: -2 },
  )
  const weight = (p) => Math.exp(-dot(p, p) / 5000)
  agree(
    mask(twisted[0], ({ position }) => position.dot(position).div(-5000).exp()),
    (p, inputs) => times(twisted[1](p, inputs), weight(p)),
  )
  // In a chain, the previous warp has already moved the points.
  agree(
    chain(
      waved[0],
      mask(bent[0], ({ position }) => position.dot(position).div(-5000).exp()),
    ),
    (p, inputs) => {
      const moved = plus(p, waved[1](p, inputs))
      return plus(subtract(moved, p), times(bent[1](moved, inputs), weight(moved)))
    },
  )
})
