// Integers that are frame constants: shaders of each language reassemble them from two halves, and the results must equal JavaScript's.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { compileWarp } from '../../dist/warpjet.js'
import { openPipelines } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

const outputs = [{ name: 'offset', shape: 3 }]

/** Returns the offset at p for each value of the uniform `seed`. */
async function offsetsOf(target, source, seeds, p) {
  const warp = compileWarp(glslOffset(source), {
    ...{ target, perFrame: true, normals: false, uniforms: { seed: 0 }, names: { position: 'p' } },
  })
  const { warpjetFrame0, ...others } = warp.frameUniforms({ seed: 1 })
  assert.ok(warpjetFrame0 && Object.keys(others).length === 0)
  const inputs = [
    { name: 'p', shape: 3 },
    { name: 'warpjetFrame0', shape: 4 },
  ]
  const points = seeds.map((seed) => [...p, ...warp.frameUniforms({ seed }).warpjetFrame0])
  const values = await pipelines.run(target, { ...warp, inputs, outputs }, points)
  return values.map((numbers) => [...numbers])
}

const hash = (bits) => {
  const h = Math.imul(bits ^ (bits >>> 16), 747796405) >>> 0
  return (h ^ (h >>> 15)) >>> 0
}
const bitsOf = (x) => new Uint32Array(Float32Array.of(x).buffer)[0]
const seeds = [0, 1, -1, 2.75, -3.5e-9, 123456789, -1e30, 6e8, 7]

for (const target of ['glsl300', 'wgsl'])
  test(`integers keep all 32 bits, in ${target}`, async () => {
    const source = `#version 300 es
      uniform float seed;
      uint hash(uint v) { uint h = (v ^ (v >> 16u)) * 747796405u; return h ^ (h >> 15u); }
      vec3 offset(vec3 p) {
        uint h = hash(floatBitsToUint(seed)) + uint(p.x);
        return vec3(float(h & 65535u), float(h >> 16u), 0.0);
      }`
    const expected = seeds.map((seed) => {
      const h = (hash(bitsOf(seed)) + 5) >>> 0
      return [h & 0xffff, h >>> 16, 0]
    })
    assert.deepEqual(await offsetsOf(target, source, seeds, [5, 0, 0]), expected)
  })

for (const target of ['glsl100', 'glsl300', 'wgsl'])
  test(`integer arithmetic without bit operations is exact, in ${target}`, async () => {
    const source = `uniform float seed;
      vec3 offset(vec3 p) { int n = int(seed) / 3 + int(p.x); return vec3(float(n - n / 1000 * 1000), float(n / 1000), 0.0); }`
    const integers = [0, 1, -1, 40000, -40000, 9999999, -1234567, 2e7, 6e8, -2e9]
    const expected = integers.map((seed) => {
      const n = Math.trunc(seed / 3) + 5
      const thousands = Math.trunc(n / 1000)
      return [n - thousands * 1000, thousands, 0].map((x) => x + 0)
    })
    const actual = await offsetsOf(target, source, integers, [5, 0, 0])
    assert.deepEqual(
      actual.map((numbers) => numbers.map((x) => x + 0)),
      expected,
    )
  })
