// The time of the compiler is linear in each number that can be in the thousands: of parameters, results, functions, uniforms, ….
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { loadMesh } from '../../dist/mesh.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { assertLinear, few, many, timeOf } from '../support/linear-time.js'

const sumOf = (glsl, count, operand) => {
  let sum = glsl.param('first')
  for (let i = 0; i < count; i++) sum = sum.add(operand(i)).sin()
  return sum
}
const compileSum = (operand) => (count) =>
  compile((glsl) => ({ y: sumOf(glsl, count, (i) => operand(glsl, i)) }))

test('parameters take linear time', () =>
  assertLinear(compileSum((glsl, i) => glsl.param(`p${i}`))))

test('parameters named like temporaries take linear time', () =>
  assertLinear(compileSum((glsl, i) => glsl.param(`t${i}`))))

test('results take linear time', () =>
  assertLinear((count) =>
    compile((glsl) => {
      const x = glsl.param('x')
      return Object.fromEntries(Array.from({ length: count }, (_, i) => [`r${i}`, x.add(i).sin()]))
    }),
  ))

test('functions take linear time', () => {
  const source = (i) => `float f${i}(float x) { return x; }`
  return assertLinear(
    compileSum((glsl, i) => glsl.fn({ name: `f${i}`, arity: 1, source: source(i) })(i)),
  )
})

test('derivatives with respect to parameters take linear time', () =>
  assertLinear(
    compileSum((glsl, i) => {
      const p = glsl.param(`p${i}`)
      return glsl.derivative(p.sin().mult(p), p)
    }),
  ))

test('uniforms take linear time, also on the CPU', async () => {
  const offset = (count) => (inputs) =>
    inputs.glsl.vec3(
      0,
      0,
      sumOf(inputs.glsl, count, (i) => inputs.uniforms[`u${i}`]),
    )
  const uniforms = (count) =>
    Object.fromEntries(Array.from({ length: count }, (_, i) => [`u${i}`, i / count]))
  const make = (count) => compileWarp(offset(count), { uniforms: uniforms(count) })
  await assertLinear(make)
  const warps = new Map([few, many].map((count) => [count, make(count)]))
  const evaluate = (count) =>
    warps.get(count).evaluateAt([0, 0, 0], { uniforms: { ...uniforms(count), first: 0 } })
  await assertLinear(evaluate)
})

/** Makes a .gltf of `count` nodes, each with its own mesh, accessor and view: 340 bytes of JSON per node. */
function gltfOf(count) {
  const positions = Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer)
  const list = (make) => Array.from({ length: count }, (_, i) => make(i))
  const json = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: list((i) => ({ name: `node ${i}`, mesh: i, translation: [i / 7, i / 3, -i / 11] })),
    meshes: list((i) => ({ name: `mesh ${i}`, primitives: [{ attributes: { POSITION: i } }] })),
    accessors: list((i) => ({
      bufferView: i,
      componentType: 5126,
      count: 3,
      type: 'VEC3',
      min: [0, 0, 0],
      max: [1, 1, 0],
    })),
    bufferViews: list(() => ({ buffer: 0, byteOffset: 0, byteLength: 36, target: 34962 })),
    buffers: [
      {
        byteLength: 36,
        uri: `data:application/octet-stream;base64,${positions.toString('base64')}`,
      },
    ],
  }
  return new TextEncoder().encode(JSON.stringify(json))
}

test('reading the JSON of a glTF takes linear time', async () => {
  const files = new Map([few, many].map((count) => [count, gltfOf(count)]))
  await assertLinear((count) => loadMesh(files.get(count)))
  // The bound is relative to the time of JSON.parse for the same file, and so independent of the computer. Measured: 18 times as long;
  // formerly 45 times.
  const bytes = files.get(many)
  const text = new TextDecoder().decode(bytes)
  const ours = await timeOf(() => loadMesh(bytes), 0, 5)
  const ratio = ours / (await timeOf(() => JSON.parse(text), 0, 9))
  const perMegabyte = `${ours / bytes.length} s a MB`
  assert.ok(ratio < 30, `${ratio} times as long as JSON.parse, ${perMegabyte}`)
})
