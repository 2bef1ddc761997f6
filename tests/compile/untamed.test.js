// Random expressions that are not restricted to domains of operations, as offsets at points where float32 overflows and underflows: the
// normal of a vertex with a finite position is never NaN.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { textOf } from '../random/ast.js'
import { callbackOf } from '../random/check.js'
import { randomCase, randomOf } from '../random/generate.js'

const count = 2000
const pointsPerCase = 32
// The compiler assumes that inputs are no larger than the last of `assumedSizes` (`assumedMagnitude` in src/graph/graph.hpp).
const assumedSizes = [0, 1e-30, 1e-19, 1, 1e4]
const hugeSizes = [1e19, 1e20, 2.5e20, 1e30]

/** The inputs of the expressions, computed from the position. */
const inputs = `
  const [x, y, z] = [position.x(), position.y(), position.z()]
  const [p, q, r] = [position.xz(), position, glsl.vec4(position, 1)]
  const a = glsl.mat2(p, position.xy())
  const b = glsl.mat3(position, position.yzx(), glsl.vec3(1, 0, 1))
  const c = glsl.mat4(r, glsl.vec4(0, 1, 0, 0), r.wzyx(), glsl.vec4(p, 0, 1))
`

const offsets = {
  float: 'glsl.vec3(0, 0, value)',
  vec2: 'glsl.vec3(value, 0)',
  vec3: 'value',
  vec4: 'value.xyz()',
  mat2: 'glsl.vec3(value.column(1), 0)',
  mat3: 'value.column(1)',
  mat4: 'value.column(1).xyz()',
  bool: 'glsl.vec3(0, value.ifElse(1, 0), 0)',
}

/** Compiles an expression as an offset; returns `undefined` if the compiler rejects it, since it is not finite for any input. */
function warpOf(root) {
  const body = `${inputs}const value = ${textOf(root)}\nreturn ${offsets[root.shape]}`
  try {
    return compileWarp(callbackOf(`({ glsl, position }) => {${body} }`))
  } catch (error) {
    assert.equal(error.constructor.name, 'WarpError', `${error}`)
  }
}

/** Returns random vertices. Each coordinate has one of the sizes; at every fourth vertex, all coordinates are the same. */
function verticesOf(seed, sizes) {
  const random = randomOf(3e6 + seed)
  const pick = (list) => list[Math.floor(list.length * random())]
  const coordinate = () => pick(sizes) * pick([1, -1])
  const directions = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0.48, 0.6, 0.64],
  ]
  const [positions, normals] = [[], []]
  for (let i = 0; i < pointsPerCase; i++) {
    positions.push(
      ...(i % 4 ? [coordinate(), coordinate(), coordinate()] : Array(3).fill(coordinate())),
    )
    normals.push(...pick(directions))
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals) }
}

const tripleOf = (array, i) => Array.from(array.subarray(3 * i, 3 * i + 3))

const cases = Array.from({ length: count }, (_, seed) => {
  const { root } = randomCase(seed, undefined, false)
  return { seed, root, warp: warpOf(root) }
}).filter(({ warp }) => warp)

/** Describes, for each expression, the first vertex that has a finite position and a normal whose length is neither 1 nor 0. */
function failuresOf(sizes, t, maxZeroShare = 0.1) {
  const failures = []
  let [normalCount, zeroCount] = [0, 0]
  for (const { seed, root, warp } of cases) {
    const vertices = verticesOf(seed, sizes)
    const warped = warp.evaluate(vertices)
    for (let i = 0; i < pointsPerCase; i++) {
      if (!tripleOf(warped.positions, i).every(Number.isFinite)) continue
      const length = Math.hypot(...tripleOf(warped.normals, i))
      normalCount++
      if (length === 0) zeroCount++
      if (length === 0 || Math.abs(length - 1) < 1e-5) continue
      const position = tripleOf(vertices.positions, i)
      failures.push(`${seed} at ${position}: ${tripleOf(warped.normals, i)} of ${textOf(root)}`)
      break
    }
  }
  t.diagnostic(`${normalCount} normals, ${zeroCount} of them zero; ${failures.length} failures`)
  assert.ok(
    normalCount > 0.4 * count * pointsPerCase && zeroCount < maxZeroShare * normalCount,
    'too few normals, or too many zero normals',
  )
  return failures
}

test('few expressions are rejected', () => assert.ok(cases.length > 0.9 * count, `${cases.length}`))

test('normals have length 1, or are zero', (t) => {
  assert.deepEqual(failuresOf(assumedSizes, t), [])
})

// Normals are zero where products of slopes overflow float32: scaling each product would cost every warp a dozen operations per vertex.
for (const sizes of [
  [...assumedSizes, ...hugeSizes],
  [1e20, 1.5e20, 1],
])
  test(`normals have length 1, or are zero, also at positions of the sizes ${sizes}`, (t) => {
    assert.deepEqual(failuresOf(sizes, t, 0.2), [])
  })
