// Tests the mesh module when memory runs out, wasm traps, or files are hostile: it throws a message, and the next call works.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { readGlb, writeGlb } from '../support/glb.js'
import { checkMemoryAfterEach, material, twist } from '../support/mesh-tests.js'
import { grid, sphere, triangle } from '../support/meshes.js'
import { checkWarpError, rejectsWithWarpError, throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('failures of the wasm module', () => {
  test('running out of memory throws a message, and the next call works', () => {
    const tooMany = new Array(3 * 2 ** 29)
    for (const mesh of [
      { positions: tooMany },
      { ...triangle(), indices: new Float64Array(0), uvs: tooMany },
    ])
      throwsWarpError(() => exportGLB(mesh), /^exportGLB: there is not enough memory/)
  })

  test('a browser that provides no more memory causes a message', () => {
    const { grow } = WebAssembly.Memory.prototype
    const mesh = grid(500, 500)
    WebAssembly.Memory.prototype.grow = () => {
      throw new RangeError('no more')
    }
    try {
      throwsWarpError(
        () => subdivide(mesh, { levels: 3, maxTriangles: 2 ** 25 }),
        /^subdivide: there is not enough memory/,
      )
    } finally {
      WebAssembly.Memory.prototype.grow = grow
    }
    assert.ok(exportGLB(mesh).length > 24 * 250000)
  })

  /** An array with a wrong length, which makes the module write out of bounds. */
  class Liar extends Float32Array {
    get length() {
      return 9
    }
  }

  test('an uncaught C++ exception becomes a message', () => {
    class Thrower extends Float32Array {
      get length() {
        throw new WebAssembly.Exception(new WebAssembly.Tag({ parameters: [] }), [])
      }
    }
    throwsWarpError(
      () => exportGLB({ positions: new Thrower(9) }),
      /^exportGLB: the mesh is too large/,
    )
  })

  test('a trap inside a warp ends the outer call too, and does not hide an error of the warp', () => {
    const liar = { positions: new Liar(2 ** 24) }
    const outer = (evaluate) => () => subdivide(triangle(), { warp: { evaluate }, tolerance: 1 })
    const trap = () => throwsWarpError(() => exportGLB(liar), /^exportGLB: the mesh is too large/)
    throwsWarpError(
      outer(() => exportGLB(liar)),
      /^exportGLB: the mesh is too large/,
    )
    throwsWarpError(
      outer((vertices) => {
        trap()
        return twist.evaluate(vertices)
      }),
      /^subdivide: the mesh is too large/,
    )
    assert.throws(
      outer(() => {
        trap()
        throw new TypeError('mine')
      }),
      /^TypeError: mine$/,
    )
  })

  test('a write out of bounds throws a message, and the next call uses a new instance', () => {
    throwsWarpError(
      () => exportGLB({ positions: new Liar(2 ** 24) }),
      /^exportGLB: the mesh is too large/,
    )
  })

  test('errors of the warp itself are rethrown, even if they look like a trap', () => {
    for (const error of [
      new WebAssembly.RuntimeError('unreachable'),
      new RangeError('mine'),
      undefined,
    ]) {
      const warp = {
        evaluate() {
          throw error
        },
      }
      let thrown = 'nothing'
      try {
        subdivide(triangle(), { warp, tolerance: 1 })
      } catch (caught) {
        thrown = caught
      }
      assert.equal(thrown, error)
    }
  })

  test('a warp may call functions of warpjet/mesh itself', () => {
    const warp = {
      evaluate(vertices) {
        const coarse = { warp: twist, tolerance: 1, angle: 4 }
        assert.equal(subdivide(triangle(), coarse).positions.length, 9)
        return twist.evaluate(vertices)
      },
    }
    const options = { tolerance: 0.1 }
    assert.deepEqual(
      subdivide(sphere(), { ...options, warp }),
      subdivide(sphere(), { ...options, warp: twist }),
    )
  })
})

describe('hostile files', () => {
  const file = exportGLB({ ...sphere(6, 4), material })

  test('are rejected if they are truncated anywhere', async () => {
    for (let length = 0; length < file.length; length += length < 3000 ? 13 : 97)
      await rejectsWithWarpError(() => loadMesh(file.slice(0, length)), /^loadMesh: /)
  })

  test('with flipped bits give a mesh or a message', async () => {
    let seed = 12345
    const random = (n) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) % n
    let rejectedCount = 0
    for (let i = 0; i < 600; i++) {
      const broken = file.slice()
      for (let k = random(4); k >= 0; k--) broken[random(2200)] ^= 1 << random(8)
      try {
        const { positions } = await loadMesh(broken)
        assert.ok(positions.every(Number.isFinite))
      } catch (error) {
        checkWarpError(error, /^loadMesh: /)
        rejectedCount++
      }
    }
    assert.ok(rejectedCount > 100)
  })

  test('with sizes beyond the end of the file are rejected', async () => {
    const { json, chunks } = readGlb(file)
    const rejectsChange = (change) => {
      const document = structuredClone(json)
      change(document)
      return rejectsWithWarpError(
        () => loadMesh(writeGlb(document, chunks[1].bytes)),
        /^loadMesh: /,
      )
    }
    await rejectsChange(({ accessors }) => (accessors[0].count = 2 ** 32 - 1))
    await rejectsChange(({ accessors }) => (accessors[0].count = 2 ** 53))
    await rejectsChange(({ accessors }) => (accessors[0].byteOffset = 2 ** 31))
    await rejectsChange(({ bufferViews }) => (bufferViews[0].byteLength = 2 ** 32 - 4))
    await rejectsChange(({ bufferViews }) => (bufferViews[0].byteStride = 252))
    await rejectsChange(({ buffers }) => (buffers[0].byteLength = 4e9))
    await rejectsChange(({ nodes }) => nodes.push({ children: [0] }) && (nodes[0].children = [1]))
  })

  test('with deeply nested brackets are rejected', async () => {
    const deep = `{"asset":{"version":"2.0"},"extras":${'['.repeat(1e6)}${']'.repeat(1e6)}}`
    await rejectsWithWarpError(() => loadMesh(new TextEncoder().encode(deep)), /^loadMesh: /)
    await rejectsWithWarpError(() => loadMesh(writeGlb(deep)), /^loadMesh: /)
  })
})
