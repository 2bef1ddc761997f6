// Tests that a call of `evaluate` into arrays of the caller creates no garbage, and keeps no references to them.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { setTimeout } from 'node:timers/promises'
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { compileWarp } from '../../dist/warpjet.js'
import { bytesOf } from '../support/allocated-bytes.js'

setFlagsFromString('--expose-gc')
const collect = runInNewContext('gc')

const wave = ({ glsl, position, millis }) =>
  glsl.vec3(position.y().mult(4).add(millis.div(500)).sin().mult(0.15), 0, 0)

const towards = ({ position, uniforms: { center, amount } }) =>
  position.sub(center).sin().mult(amount)

const numbers = (count) => Float32Array.from({ length: count }, (_, i) => Math.sin(i))
const arrays = (vertices) => ({ positions: numbers(3 * vertices), normals: numbers(3 * vertices) })

describe('evaluate into arrays of the caller allocates nothing, whatever the number of vertices', () => {
  const x = 0.25
  const cases = {
    'a uniform passed to the call': [compileWarp(wave), { millis: 5 }],
    'a vector uniform passed to the call': [
      compileWarp(towards, { uniforms: { center: [0, 0, 0], amount: 0.5 } }),
      { center: [0.5, 0.25, 1] },
    ],
    'declared uniforms, one of which is a function': [
      compileWarp(towards, { uniforms: { center: [0, 0, 0], amount: () => x } }),
    ],
  }
  for (const [name, [warp, uniforms]] of Object.entries(cases))
    test(name, async () => {
      const makeCall = (vertices) => {
        const mesh = arrays(vertices)
        const options = { uniforms, out: arrays(vertices) }
        return () => warp.evaluate(mesh, options)
      }
      // Calls often enough that the engine optimizes the code, and that the warp is compiled to machine code.
      const smallCall = makeCall(8)
      for (let i = 0; i < 20_000; i++) smallCall()
      const sizes = {}
      // The last size needs several batches of machine code, of which one is not full.
      for (const vertices of [8, 80, 2000, 9000])
        sizes[vertices] = await bytesOf(makeCall(vertices), vertices > 1000 ? 1000 : 4000)
      // The smallest object takes 16 bytes, and an array another 16; occasional smaller allocations are the engine's own.
      for (const bytes of Object.values(sizes)) assert.ok(bytes < 16, JSON.stringify(sizes))
    })
})

test('evaluate returns the object of the caller, unless it contains other arrays', () => {
  const warp = compileWarp(wave)
  const mesh = arrays(5)
  const uniforms = { millis: 5 }
  const out = arrays(5)
  assert.equal(warp.evaluate(mesh, { uniforms, out }), out)

  const { positions, normals } = arrays(5)
  const partly = warp.evaluate(mesh, { uniforms, out: { positions } })
  assert.equal(partly.positions, positions)
  assert.deepEqual(partly, out)

  const more = { positions, normals, tangents: new Float32Array(20) }
  assert.deepEqual(warp.evaluate(mesh, { uniforms, out: more }), out)
})

test('the function of a uniform, or a getter, may evaluate the same warp', () => {
  const mesh = arrays(7)
  const other = arrays(9)
  let isNested = false
  let amount = 0.5
  const nestedResults = []
  let warp
  const nested = () => {
    if (isNested || !warp) return
    isNested = true
    nestedResults.push(warp.evaluate(other, { uniforms: { amount: 0.25 }, out: arrays(9) }))
    isNested = false
  }
  warp = compileWarp(towards, {
    uniforms: { center: [1, 2, 3], amount: () => (nested(), amount) },
  })
  // Later calls reuse objects of the first ones.
  for (const _ of [1, 2, 3]) {
    const plain = compileWarp(towards, { uniforms: { center: [1, 2, 3], amount } })
    const expected = plain.evaluate(mesh)
    const meshWithGetter = {
      positions: mesh.positions,
      get normals() {
        nested()
        return mesh.normals
      },
    }
    assert.deepEqual(warp.evaluate(mesh, { out: arrays(7) }), expected)
    assert.deepEqual(warp.evaluate(meshWithGetter, { out: arrays(7) }), expected)
    const expectedInside = plain.evaluate(other, { uniforms: { amount: 0.25 } })
    for (const result of nestedResults.splice(0)) assert.deepEqual(result, expectedInside)
    amount += 0.25
  }
})

test('the call after one that throws is correct', () => {
  const warp = compileWarp(towards, { uniforms: { center: [1, 2, 3], amount: 0.5 } })
  const mesh = arrays(7)
  const expected = warp.evaluate(mesh)
  const out = arrays(7)
  assert.throws(() => warp.evaluate(mesh, { uniforms: { center: [9, 9, NaN] }, out }), /NaN/)
  assert.throws(() => warp.evaluate(mesh, { uniforms: { amount: [1] }, out }), /got an array of 1/)
  assert.throws(
    () => warp.evaluate(mesh, { out: { positions: new Float32Array(2) } }),
    /got one of 2/,
  )
  assert.deepEqual(warp.evaluate(mesh, { out }), expected)
})

test('evaluate reads new numbers in the same arrays, and accepts arrays that have grown', () => {
  const warp = compileWarp(wave)
  const uniforms = { millis: 5 }
  const buffer = new ArrayBuffer(12 * 9000, { maxByteLength: 12 * 10_000 })
  const mesh = { positions: new Float32Array(buffer) }
  for (const vertices of [9000, 9000, 10_000, 5000]) {
    buffer.resize(12 * vertices)
    for (let i = 0; i < 3 * vertices; i++) mesh.positions[i] = Math.cos(i * vertices)
    const copied = { positions: mesh.positions.slice() }
    const out = { positions: new Float32Array(3 * vertices) }
    assert.deepEqual(warp.evaluate(mesh, { uniforms, out }), warp.evaluate(copied, { uniforms }))
  }
})

test('arrays of the caller are not retained', async () => {
  const warp = compileWarp(wave)
  const makeInput = () => {
    const mesh = arrays(9000)
    const out = arrays(9000)
    for (let i = 0; i < 3; i++) warp.evaluate(mesh, { uniforms: { millis: 5 }, out })
    return [mesh.positions, mesh.normals, out.positions, out.normals].map(
      (array) => new WeakRef(array),
    )
  }
  const references = makeInput()
  for (let i = 0; i < 5; i++) {
    await setTimeout(1)
    collect()
  }
  assert.deepEqual(
    references.map((reference) => reference.deref()?.length),
    references.map(() => undefined),
  )
  assert.ok(warp.evaluate(arrays(3), { uniforms: { millis: 5 } }))
})
