// Tests chain, add, blend, mask and inSpace: positions and normals equal those of the same composition of plain functions, computed
// step by step.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import {
  add,
  bend,
  blend,
  bulge,
  chain,
  inSpace,
  inflate,
  mask,
  shear,
  spherify,
  stretch,
  taper,
  twist,
  wave,
} from '../../dist/deformers.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import {
  columnMajor,
  cross,
  dot,
  movePoint,
  normalize,
  add as plus,
  product,
  rotation,
  scaling,
  subtract,
  translation,
  turnNormal,
} from '../support/browser/matrix.js'
import { angleBetween, jacobian, warpVertex } from '../support/browser/oracle.js'
import { throwsWarpError } from '../support/warp-errors.js'
import { deformers as oracles } from '../warps/deformers.js'
import { seededRandom } from '../warps/random.js'

const random = seededRandom(66)
const anyPoint = (size) => [0, 1, 2].map(() => size * (2 * random() - 1))
const vertices = Array.from({ length: 40 }, () => ({
  position: anyPoint(120),
  normal: normalize(anyPoint(1)),
  millis: 1234,
}))
const step = 0.02

/** Evaluates in double precision: maps a vertex and uniforms to the offset, the columns of its Jacobian, and the warped normal. */
function inDouble(warp) {
  return compile((glsl) => {
    const [position, normal] = [glsl.vec3Param('position'), glsl.vec3Param('normal')]
    const millis = glsl.param('millis')
    const offset = warp({ glsl, position, normal, millis })
    return {
      offset,
      derivatives: glsl.jacobian(offset, position),
      turned: offset.adjustNormal(normal, position),
      allRead: normal.mult(millis),
    }
  }).evaluate
}

function assertClose(actual, expected, tolerance) {
  actual.forEach((value, i) => {
    const off = Math.abs(value - expected[i])
    assert.ok(off <= tolerance, `${actual} is not ${expected}: ${off} off`)
  })
}

/** `oracle` is a function (position, { normal, millis, ... }) → offset. */
function agree(warp, oracle, uniforms = {}) {
  const evaluate = inDouble(warp)
  for (const vertex of vertices) {
    const inputs = { ...vertex, ...uniforms }
    const { offset, derivatives, turned } = evaluate(inputs)
    assertClose(offset, oracle(vertex.position, inputs), 1e-9)
    const columns = jacobian((p) => oracle(p, inputs), vertex.position, step)
    if (!columns) continue
    assertClose(derivatives, columns.flat(), 1e-7)
    const expected = warpVertex(oracle, vertex, inputs, step)
    if (!expected.normal?.some(Boolean)) continue
    const angle = angleBetween(turned, expected.normal)
    assert.ok(angle < 1e-5 * expected.sensitivity, `${angle}° at ${vertex.position}`)
  }
}

const twisted = [twist({ angle: 1.3 }), oracles.twist({ angle: 1.3 })]
const bent = [
  bend({ axis: 'x', angle: 1, from: -150, to: 150 }),
  oracles.bend({ axis: 'x', angle: 1, from: -150, to: 150 }),
]
const waved = [wave({ amount: 5 }), oracles.wave({ amount: 5 })]

const times = (v, factor) => v.map((x) => x * factor)
const after = (a, b) => (p, inputs) => {
  const first = a(p, inputs)
  return plus(first, b(plus(p, first), inputs))
}
/** Returns the normal of the surface moved by `offset`, at the image of p, from finite differences only. */
const normalAfter = (offset, p, inputs) =>
  warpVertex(offset, { position: p, normal: inputs.normal }, inputs, step).normal

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
      const { offset, derivatives, turned } = evaluate({
        position: [x, 0, 7],
        normal: [0, 1, 0],
        millis: 0,
      })
      assertClose(offset, [(-30 * slope) / length, x ** 2 / 200 + 30 / length, 0], 1e-9)
      // The derivatives of these offsets with respect to x. A parallel surface has the same normals as the original.
      const byX = [-0.3 / length ** 3, slope - (0.3 * slope) / length ** 3, 0]
      assertClose(derivatives.slice(0, 3), byX, 1e-9)
      assertClose(turned, [-slope / length, 1 / length, 0], 1e-9)
    }
  })

  test('computes no unused normal', () => {
    const matrix = columnMajor(spaces['a rotation'])
    const warp = chain(
      waved[0],
      inSpace(matrix, chain(twisted[0], bent[0])),
      blend(twisted[0], bent[0]),
    )
    const noNormals = (glsl) => ({
      ...glsl,
      adjustNormal: () => assert.fail('a normal was made'),
    })
    compileWarp((inputs) => warp({ ...inputs, glsl: noNormals(inputs.glsl) }))
    assert.throws(
      () =>
        compileWarp((inputs) =>
          chain(warp, inflate())({ ...inputs, glsl: noNormals(inputs.glsl) }),
        ),
      /a normal was made/,
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
  const near = (p) => Math.exp(-dot(p, p) / 5000)
  agree(
    mask(twisted[0], ({ position }) => position.dot(position).div(-5000).exp()),
    (p, inputs) => times(twisted[1](p, inputs), near(p)),
  )
  // In a chain, the previous warp has already moved the points.
  agree(
    chain(
      waved[0],
      mask(bent[0], ({ position }) => position.dot(position).div(-5000).exp()),
    ),
    (p, inputs) => {
      const moved = plus(p, waved[1](p, inputs))
      return plus(subtract(moved, p), times(bent[1](moved, inputs), near(moved)))
    },
  )
})

const spaces = {
  'a translation': translation(30, -20, 7),
  'a rotation': rotation(0.8, 0, 1),
  'a rotation, a scale and a translation': product(
    translation(5, 6, 7),
    rotation(1, 1, 2),
    scaling(0.5, 2, 1.5),
  ),
  'a shear': [
    [1, 0.5, 0, 0],
    [0, 1, -0.3, 2],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ],
  'a mirror': product(translation(1, 2, 3), scaling(-1, 1, 2)),
}

/** The inverse transform of directions. */
function backward(matrix, v) {
  const [a, b, c] = matrix.slice(0, 3).map((row) => row.slice(0, 3))
  const determinant = dot(a, cross(b, c))
  const inverse = [cross(b, c), cross(c, a), cross(a, b)]
  return [0, 1, 2].map(
    (i) => (inverse[0][i] * v[0] + inverse[1][i] * v[1] + inverse[2][i] * v[2]) / determinant,
  )
}
const inside = (matrix, oracle) => (p, inputs) =>
  backward(
    matrix,
    oracle(movePoint(matrix, p), { ...inputs, normal: turnNormal(matrix, inputs.normal) }),
  )

describe('inSpace', () => {
  for (const [name, matrix] of Object.entries(spaces)) {
    test(`applies a warp in the space of ${name}, for each form of the matrix`, () => {
      const flat = columnMajor(matrix)
      for (const form of [
        flat,
        Float32Array.from(flat),
        () => flat,
        ({ glsl }) => glsl.mat4(...flat),
      ])
        if (!(form instanceof Float32Array))
          agree(inSpace(form, twisted[0]), inside(matrix, twisted[1]))
        else assert.equal(typeof inSpace(form, twisted[0]), 'function')
      agree(
        inSpace(({ glsl }) => glsl.mat4Param('m'), bent[0]),
        inside(matrix, bent[1]),
        { m: flat },
      )
      agree(
        (inputs) => inSpace(inputs.glsl.mat4(...flat), bent[0])(inputs),
        inside(matrix, bent[1]),
      )
    })

    test(`transforms normals into the space and back: ${name}`, () => {
      const flat = columnMajor(matrix)
      agree(inSpace(flat, inflate({ amount: 8 })), inside(matrix, oracles.inflate({ amount: 8 })))
      // A normal points outwards, and an offset along it has an outward component, also under a mirror.
      const evaluate = inDouble(inSpace(flat, inflate({ amount: 8 })))
      for (const vertex of vertices) assert.ok(dot(evaluate(vertex).offset, vertex.normal) > 0)
    })

    test(`works inside and outside of chains: ${name}`, () => {
      const flat = columnMajor(matrix)
      const around = chain(waved[0], inSpace(flat, chain(twisted[0], inflate({ amount: 8 }))))
      const evaluate = inDouble(around)
      for (const vertex of vertices) {
        const p = vertex.position
        const before = waved[1](p, vertex)
        const normal = turnNormal(matrix, normalAfter(waved[1], p, vertex))
        const place = movePoint(matrix, plus(p, before))
        const within = twisted[1](place, vertex)
        const turned = normalAfter(twisted[1], place, { ...vertex, normal })
        const expected = plus(before, backward(matrix, plus(within, times(turned, 8))))
        assertClose(evaluate(vertex).offset, expected, 1e-5)
      }
    })
  }

  test('accepts a mat3, which has no translation', () => {
    const matrix = product(rotation(0.4, 0, 2), scaling(2, 1, 0.5))
    const numbers = [0, 1, 2].flatMap((i) => matrix.slice(0, 3).map((row) => row[i]))
    agree(
      inSpace(({ glsl }) => glsl.mat3(...numbers), twisted[0]),
      inside(matrix, twisted[1]),
    )
    agree(
      inSpace(({ glsl }) => glsl.mat3Param('m'), twisted[0]),
      inside(matrix, twisted[1]),
      { m: numbers },
    )
  })

  test('does not move points while a computed matrix has determinant 0', () => {
    const warp = compileWarp(inSpace(({ glsl }) => glsl.mat3Param('m'), twisted[0]))
    const m = [1, 0, 0, 2, 0, 0, 0, 0, 1]
    const { position, normal } = warp.evaluateAt([1, 2, 3], {
      normal: [0, 0.6, 0.8],
      uniforms: { m },
    })
    assert.deepEqual(position, [1, 2, 3])
    assertClose(normal, [0, 0.6, 0.8], 1e-7)
  })
})

test('deformers and compositions compile to one piece of code in all three languages', () => {
  const all = chain(
    blend(taper(), stretch({ keepVolume: true }), 0.4),
    mask(add(bulge(), shear()), ({ position }) => position.y().mult(0.01).sin()),
    inSpace(columnMajor(spaces['a rotation']), spherify({ amount: 0.3 })),
  )
  for (const target of ['glsl300', 'glsl100', 'wgsl'])
    assert.match(compileWarp(all, { target }).code, /warpedNormal/)
})
