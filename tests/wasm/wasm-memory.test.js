// Tests that the wasm modules use as much memory after a call as before it, whatever happens in the call.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import {
  evaluationMemoryInUse,
  glslMemoryInUse,
  memoryInUse,
  meshMemoryInUse,
} from '../../dist/memory.js'
import { subdivide } from '../../dist/mesh.js'
import { compile, compileWarp } from '../../dist/warpjet.js'

const measureMemory = () => ({
  core: memoryInUse(),
  evaluation: evaluationMemoryInUse(),
  glsl: glslMemoryInUse(),
  mesh: meshMemoryInUse(),
})

const mesh = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0) }
const zeroOffset = ({ glsl }) => glsl.vec3(0, 0, 0)

const cases = {
  'a warp that uses every type that embind passes': () =>
    compileWarp(
      ({ glsl, position, uniforms }) => {
        const wave = glsl.fn({
          name: 'wave',
          arity: 1,
          source: { glsl: 'float wave(float x) { return sin(x); }' },
          derivatives: [(x) => x.cos()],
        })
        const height = glsl.texture('heights', position.xy, { filter: 'bicubic', wrap: 'mirror' })
        const { sum } = glsl.repeat(3, { sum: 0 }, ({ sum }) => ({ sum: sum.add(position.x) }))
        return glsl.vec3(wave(uniforms.height.add(sum)), height.x, 0)
      },
      { uniforms: { height: 1 } },
    ),
  'a function that throws': () => {
    compileWarp(() => {
      throw new Error('mine')
    })
  },
  'a warp that cannot be compiled': () =>
    compile((glsl) => ({ y: glsl.param('x').add(glsl.vec2Param('v')).z })),
  'shader source': () =>
    compileWarp(glslOffset('vec3 offset(vec3 p) { return p * 2.0; } // größer')),
  'shader source with a mistake': () => glslOffset('vec3 offset(vec3 p) { return q; }'),
  'evaluation on the CPU': () => {
    const warp = compileWarp(({ position }) => position.sin())
    warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] })
    for (let i = 0; i < 3; i++) warp.evaluate(mesh)
    warp.inverseAt([0.1, 0.2, 0.3])
  },
  'a mesh whose warp throws': () =>
    subdivide(mesh, {
      tolerance: 1,
      warp: {
        evaluate() {
          throw new Error('mine')
        },
      },
    }),
  'a mesh whose warp uses meshes': () => {
    const warp = compileWarp(zeroOffset)
    const nested = {
      evaluate: (vertices) => (subdivide(mesh, { levels: 1 }), warp.evaluate(vertices)),
    }
    subdivide(mesh, { tolerance: 1, warp: nested })
  },
}

for (const [name, work] of Object.entries(cases))
  test(name, () => {
    const outcome = () => {
      try {
        work()
        return 'done'
      } catch (error) {
        return error.message
      }
    }
    const first = outcome()
    const before = measureMemory()
    for (let i = 0; i < 20; i++) assert.equal(outcome(), first)
    assert.deepEqual(measureMemory(), before)
    if (/throws|cannot|mistake/.test(name)) assert.notEqual(first, 'done')
    else assert.equal(first, 'done')
  })
