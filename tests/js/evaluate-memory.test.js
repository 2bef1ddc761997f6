// What a call of `evaluate` leaves for the garbage collector.
import assert from 'node:assert/strict'
import { Session } from 'node:inspector/promises'
import { test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'

const warp = compileWarp(({ glsl, position, millis }) =>
  glsl.vec3(position.y().mult(4).add(millis.div(500)).sin().mult(0.15), 0, 0),
)

/** Bytes of JavaScript's heap that a call takes, as the engine's sampling sees them, collected since or not. */
async function bytesOf(call) {
  const calls = 4000
  // Until the engine has taken its best compiler, and the warp has its machine code.
  for (let i = 0; i < 20_000; i++) call()
  const session = new Session()
  session.connect()
  await session.post('HeapProfiler.startSampling', {
    samplingInterval: 256,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  })
  for (let i = 0; i < calls; i++) call()
  const { profile } = await session.post('HeapProfiler.stopSampling')
  session.disconnect()
  const total = ({ selfSize, children }) =>
    children.reduce((sum, each) => sum + total(each), selfSize)
  return total(profile.head) / calls
}

const numbers = (count) => Float32Array.from({ length: count }, (_, i) => Math.sin(i))

test('evaluate into arrays of the caller takes 3 KB of small objects at most, however many vertices there are', async () => {
  const sizes = {}
  for (const vertices of [8, 80, 2000]) {
    const mesh = { positions: numbers(3 * vertices), normals: numbers(3 * vertices) }
    const out = { positions: numbers(3 * vertices), normals: numbers(3 * vertices) }
    const options = { uniforms: { millis: 5 }, out }
    sizes[vertices] = await bytesOf(() => warp.evaluate(mesh, options))
  }
  for (const bytes of Object.values(sizes)) assert.ok(bytes < 3000, JSON.stringify(sizes))
})
