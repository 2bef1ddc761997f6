// Random expressions that nothing keeps within domains, as offsets at points where float32 overflows and underflows: a normal is
// never NaN where there is a place to draw it.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { textOf } from '../random/ast.js'
import { callbackOf } from '../random/check.js'
import { randomCase, randomOf } from '../random/generate.js'

const count = 2000
const pointsOfEach = 32
// The compiler takes inputs to be no larger than the last of the usual ones (`usualSize` in src/graph/graph.hpp).
const usual = [0, 1e-30, 1e-19, 1, 1e4]
const huge = [1e19, 1e30]

/** What the expressions read, made of the position. */
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

/** The warp, and the largest entry of its offset's Jacobian at a point. Of some expressions the compiler sees that no input helps. */
function warpOf(root) {
  const offset = `const offset = ${offsets[root.shape]}`
  const body = `${inputs}const value = ${textOf(root)}\n${offset}`
  try {
    const warp = compileWarp(callbackOf(`({ glsl, position }) => {${body}\nreturn offset }`))
    const slope = compile(
      callbackOf(
        `(glsl) => { const position = glsl.vec3Param('position')\n${body}\nreturn { m: glsl.jacobian(offset, position) } }`,
      ),
    )
    const steepest = (position) => Math.max(...slope.evaluate({ position }).m.map(Math.abs))
    return { warp, steepest }
  } catch (error) {
    assert.equal(error.constructor.name, 'WarpError', `${error}`)
  }
}

/** Every coordinate one of the sizes; at every fourth point all the same one. */
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
  for (let i = 0; i < pointsOfEach; i++) {
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
  return { seed, root, ...warpOf(root) }
}).filter(({ warp }) => warp)

/** Where there is a position, but neither a normal nor none; of each expression the first. */
function failuresOf(sizes, t) {
  const failures = []
  let [seen, zero] = [0, 0]
  for (const { seed, root, warp, steepest } of cases) {
    const vertices = verticesOf(seed, sizes)
    const warped = warp.evaluate(vertices)
    for (let i = 0; i < pointsOfEach; i++) {
      if (!tripleOf(warped.positions, i).every(Number.isFinite)) continue
      const length = Math.hypot(...tripleOf(warped.normals, i))
      seen++
      if (length === 0) zero++
      if (length === 0 || Math.abs(length - 1) < 1e-5) continue
      const position = tripleOf(vertices.positions, i)
      const text = `${seed} at ${position}: ${tripleOf(warped.normals, i)} of ${textOf(root)}`
      failures.push({ text, slope: steepest(position) })
      break
    }
  }
  t.diagnostic(`${seen} normals, ${zero} of them zero; ${failures.length} failures`)
  assert.ok(seen > 0.4 * count * pointsOfEach && zero < seen / 10, 'there is something to see')
  return failures
}

test('few expressions are refused', () => assert.ok(cases.length > 0.9 * count, `${cases.length}`))

test('normals have length 1, or are zero', (t) => {
  const failures = failuresOf(usual, t)
  assert.deepEqual(
    failures.map(({ text }) => text),
    [],
  )
})

// What is left, for scaling every product of slopes that might overflow would cost each warp a dozen operations a vertex.
test('at far larger positions too, unless products of slopes are too large for float32', (t) => {
  const failures = failuresOf([...usual, ...huge], t)
  const others = failures.filter(({ slope }) => !(slope >= 4e9))
  assert.deepEqual(
    others.map(({ text }) => text),
    [],
  )
})
