// Tests inSpace: positions and normals equal those of the same composition of plain functions. `twisted`, `bent` and `waved` are pairs of
// a warp and the same offset as a plain function.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import {
  add,
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
} from '../../dist/deformers.js'
import { compileWarp } from '../../dist/warpjet.js'
import {
  columnMajor,
  cross,
  dot,
  add as plus,
  product,
  rotation,
  scaling,
  transformNormal,
  transformPoint,
  translation,
} from '../support/browser/matrix.js'
import {
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
import { deformers as oracles } from '../warps/deformers.js'

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

/** Transforms a direction by the inverse of a matrix. */
function transformBack(matrix, v) {
  const [a, b, c] = matrix.slice(0, 3).map((row) => row.slice(0, 3))
  const determinant = dot(a, cross(b, c))
  const inverse = [cross(b, c), cross(c, a), cross(a, b)]
  return [0, 1, 2].map(
    (i) => (inverse[0][i] * v[0] + inverse[1][i] * v[1] + inverse[2][i] * v[2]) / determinant,
  )
}
const oracleInSpace = (matrix, oracle) => (p, inputs) =>
  transformBack(
    matrix,
    oracle(transformPoint(matrix, p), {
      ...inputs,
      normal: transformNormal(matrix, inputs.normal),
    }),
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
          agree(inSpace(form, twisted[0]), oracleInSpace(matrix, twisted[1]))
        else assert.equal(typeof inSpace(form, twisted[0]), 'function')
      agree(
        inSpace(({ glsl }) => glsl.mat4Param('m'), bent[0]),
        oracleInSpace(matrix, bent[1]),
        { m: flat },
      )
      agree(
        (inputs) => inSpace(inputs.glsl.mat4(...flat), bent[0])(inputs),
        oracleInSpace(matrix, bent[1]),
      )
    })

    test(`transforms normals into the space and back: ${name}`, () => {
      const flat = columnMajor(matrix)
      agree(
        inSpace(flat, inflate({ amount: 8 })),
        oracleInSpace(matrix, oracles.inflate({ amount: 8 })),
      )
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
        const normal = transformNormal(matrix, normalAfter(waved[1], p, vertex))
        const place = transformPoint(matrix, plus(p, before))
        const within = twisted[1](place, vertex)
        const turned = normalAfter(twisted[1], place, { ...vertex, normal })
        const expected = plus(before, transformBack(matrix, plus(within, times(turned, 8))))
        assertClose(evaluate(vertex).offset, expected, 1e-5)
      }
    })
  }

  test('accepts a mat3, which has no translation', () => {
    const matrix = product(rotation(0.4, 0, 2), scaling(2, 1, 0.5))
    const numbers = [0, 1, 2].flatMap((i) => matrix.slice(0, 3).map((row) => row[i]))
    agree(
      inSpace(({ glsl }) => glsl.mat3(...numbers), twisted[0]),
      oracleInSpace(matrix, twisted[1]),
    )
    agree(
      inSpace(({ glsl }) => glsl.mat3Param('m'), twisted[0]),
      oracleInSpace(matrix, twisted[1]),
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

test('deformers and compositions compile together in all three languages', () => {
  const all = chain(
    blend(taper(), stretch({ keepVolume: true }), 0.4),
    mask(add(bulge(), shear()), ({ position }) => position.y().mult(0.01).sin()),
    inSpace(columnMajor(spaces['a rotation']), spherify({ amount: 0.3 })),
  )
  for (const target of ['glsl300', 'glsl100', 'wgsl'])
    assert.match(compileWarp(all, { target }).code, /warpedNormal/)
})
