// Tests subdivide: levels, tolerance, limits, and messages about wrong options.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { readGlb, writeGlb } from '../support/glb.js'
import { checkMemoryAfterEach, rise, twist } from '../support/mesh-tests.js'
import { grid, sphere, triangle } from '../support/meshes.js'
import { throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('subdivide', () => {
  // Formerly, 16,000 coincident triangles took 10 s, and more of them blocked the page.
  test('handles a model whose nodes repeat one mesh at the same place', async () => {
    const { json, chunks } = readGlb(exportGLB(triangle()))
    json.nodes = Array.from({ length: 20_000 }, () => ({ mesh: 0 }))
    json.scenes = [{ nodes: json.nodes.map((_, i) => i) }]
    json.scene = 0
    const mesh = await loadMesh(writeGlb(json, chunks[1].bytes))
    assert.equal(mesh.positions.length, 9 * 20_000)
    const start = process.cpuUsage()
    const fine = subdivide(mesh, { levels: 1 })
    const bent = subdivide(mesh, { warp: twist, tolerance: 0.1, angle: Infinity })
    const { user, system } = process.cpuUsage(start)
    assert.equal(fine.indices.length, 3 * 4 * 20_000)
    assert.equal(bent.indices.length % (3 * 20_000), 0)
    assert.ok(bent.indices.length > 3 * 20_000 && !bent.warnings)
    assert.ok(user + system < 5e6, `${(user + system) / 1e6} s`)
  })

  test('splits each triangle into four per level', () => {
    assert.equal(subdivide(triangle(), { levels: 0 }).indices.length, 3)
    assert.equal(subdivide(triangle(), { levels: 3 }).indices.length, 3 * 64)
  })

  test('splits only triangles that the warp bends, until the tolerance is met', () => {
    const bump = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, position.x().mult(position.x()).mult(0.5)),
    )
    const plane = grid(2, 2)
    const maxDeviation = (mesh) => {
      // Along x the surface is z = x² / 2: between two vertices it deviates from the chord by (the difference of their x)² / 8.
      let max = 0
      for (let i = 0; i < mesh.indices.length; i += 3) {
        const xs = [...mesh.indices.subarray(i, i + 3)].map((v) => mesh.positions[3 * v])
        max = Math.max(max, (Math.max(...xs) - Math.min(...xs)) ** 2 / 8)
      }
      return max
    }
    assert.equal(maxDeviation(plane), 1 / 8)
    const fine = subdivide(plane, { warp: bump, tolerance: 0.01, angle: Infinity })
    assert.ok(maxDeviation(fine) <= 0.01, `${maxDeviation(fine)}`)
    assert.equal(fine.warnings, undefined)
    assert.ok(fine.indices.length < 3 * 200)
    const flat = subdivide(plane, { warp: rise, uniforms: { millis: 3 }, tolerance: 0.01 })
    assert.equal(flat.indices.length, plane.indices.length)
  })

  test('stops at maxTriangles with a warning', () => {
    const options = { warp: twist, tolerance: 1e-4, maxTriangles: 500 }
    const mesh = subdivide(sphere(), options)
    assert.ok(mesh.indices.length <= 3 * 500)
    assert.equal(mesh.warnings.length, 1)
    const uniform = subdivide(triangle(), { levels: 15, maxTriangles: 100 })
    assert.equal(uniform.indices.length, 3 * 64)
    assert.deepEqual(uniform.warnings, [
      'Of 15 levels only 3 were made, with 64 triangles, for maxTriangles is 100.',
    ])
    assert.equal(subdivide(triangle(), { levels: 3, maxTriangles: 64 }).warnings, undefined)
    assert.equal(subdivide({ positions: [] }, { levels: 15 }).warnings, undefined)
  })

  test('rejects wrong options', () => {
    const rejectsOptions = (options, pattern) =>
      throwsWarpError(() => subdivide(triangle(), options), pattern)
    rejectsOptions(undefined, /^subdivide: expected options such as .*, got undefined/)
    rejectsOptions(
      {},
      /^subdivide: expected a result of compileWarp for the option "warp", got undefined/,
    )
    rejectsOptions(
      { warp: twist },
      /^subdivide: expected a number above 0 for the option "tolerance", got undefined/,
    )
    rejectsOptions(
      { warp: twist, tolerance: 0 },
      /expected a number above 0 for the option "tolerance", got the number 0/,
    )
    rejectsOptions(
      { warp: twist, tolerance: 1, angle: -1 },
      /expected a number above 0 for the option "angle", got the number -1/,
    )
    rejectsOptions(
      { levels: 1.5 },
      /expected a whole number from 0 to 15 for the option "levels", got the number 1\.5/,
    )
    rejectsOptions(
      { levels: 1, maxTriangles: 0 },
      /expected a whole number from 1 to 2\^28 for the option "maxTriangles", got the number 0/,
    )
    rejectsOptions(
      { levels: 1, maxTriangles: 2 ** 28 + 1 },
      /from 1 to 2\^28 for the option "maxTriangles", got /,
    )
    rejectsOptions(
      { levels: 1, maxTriangle: 1 },
      /^subdivide: there is no option "maxTriangle"; did you mean maxTriangles\? The options are/,
    )
    rejectsOptions(
      { warp: twist, tolerance: 1, angel: 1 },
      /^subdivide: there is no option "angel"; did you mean angle\? The options are/,
    )
    rejectsOptions({ warp: rise, tolerance: 1 }, /^subdivide: the warp reads "millis"/)
  })

  test('checks the results of objects with their own evaluate', () => {
    const rejectsEvaluate = (evaluate, pattern) => {
      for (const work of [
        () => subdivide(triangle(), { warp: { evaluate }, tolerance: 1 }),
        () => bakeWarp(triangle(), { evaluate }),
      ])
        throwsWarpError(work, pattern)
    }
    rejectsEvaluate(
      () => undefined,
      /expected the warp's evaluate to return \{ positions, normals \}, got undefined/,
    )
    rejectsEvaluate(() => ({}), /to return positions as an array of \d+ numbers, .*, got undefined/)
    rejectsEvaluate(
      ({ positions }) => ({ positions: [...positions, 0] }),
      /to return positions as an array of \d+ numbers, .*, got an array of /,
    )
    rejectsEvaluate(
      ({ positions }) => ({ positions, normals: new BigInt64Array(positions.length) }),
      /expected the warp's evaluate to return a number as normals\[0\], got the bigint 0/,
    )
    rejectsEvaluate(
      ({ positions }) => ({ positions: [...positions].map(String) }),
      /expected the warp's evaluate to return a number as positions\[0\], got the text "0"/,
    )
    let calls = 0
    const normalsOnlyOnce = ({ positions, normals }) =>
      calls++ ? { positions } : { positions, normals }
    throwsWarpError(
      () => subdivide(sphere(), { warp: { evaluate: normalsOnlyOnce }, tolerance: 0.01 }),
      /^subdivide: expected the warp's evaluate to return normals either always or never/,
    )
  })

  test('rethrows an error of the warp unchanged', () => {
    const warp = {
      evaluate() {
        throw new TypeError('mine')
      },
    }
    assert.throws(() => subdivide(triangle(), { warp, tolerance: 1 }), /^TypeError: mine$/)
  })
})
