// Tests bakeWarp: it moves positions, normals and tangents, and checks its arguments.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { box } from '../support/coarse-meshes.js'
import { deviation, edgesNotUsed } from '../support/deviation.js'
import { checkMemoryAfterEach, material, rise, twist } from '../support/mesh-tests.js'
import { sphere, triangle } from '../support/meshes.js'
import { throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('bakeWarp', () => {
  test('with detail, subdivides the mesh first, to a tolerance in the units of the mesh', async () => {
    const cube = box([90, 90, 90])
    const bend = ({ glsl, position, uniforms }) =>
      glsl.vec3(0, 0, position.x().mult(0.03).sin().mult(uniforms.height))
    const warp = compileWarp(bend, { uniforms: { height: 1 } })
    const shape = compileWarp(bend, { uniforms: { height: 1 }, normals: false })
    const uniforms = { height: 40 }
    for (const detail of [4, 0.5]) {
      const fine = subdivide(cube, { warp, uniforms, tolerance: detail })
      assert.ok(fine.indices.length > cube.indices.length)
      assert.ok(deviation(fine, shape, uniforms, 2) <= detail)
      assert.deepEqual(edgesNotUsed(2, fine), [])
      assert.deepEqual(
        bakeWarp(cube, warp, { uniforms, detail }),
        bakeWarp(fine, warp, { uniforms }),
      )
    }
    const baked = bakeWarp(cube, warp, { uniforms, detail: 0.5 })
    const bytes = exportGLB(baked)
    const { issues } = await validator.validateBytes(bytes)
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0])
    assert.deepEqual((await loadMesh(bytes)).positions, baked.positions)
    assert.deepEqual(
      bakeWarp(cube, warp, { uniforms, detail: undefined }),
      bakeWarp(cube, warp, { uniforms }),
    )
  })

  test('with detail, calls the function of a uniform only once, and returns the warnings of subdivide', () => {
    let calls = 0
    const warp = compileWarp(
      ({ glsl, position, uniforms }) => glsl.vec3(0, position.x().sin().mult(uniforms.height), 0),
      { uniforms: { height: () => ++calls } },
    )
    calls = 0 // compileWarp called the function, too
    bakeWarp(sphere(), warp, { detail: 0.01 })
    assert.equal(calls, 1)
    const jump = compileWarp(({ glsl, position }) => glsl.vec3(0, position.x().mult(0.5).abs(), 0))
    const { warnings } = subdivide(triangle(), { warp: jump, tolerance: 0.01 })
    assert.deepEqual(bakeWarp(triangle(), jump, { detail: 0.01 }).warnings, warnings)
  })

  test('rejects a wrong detail', () => {
    for (const [detail, got] of [
      [0, 'the number 0'],
      [-1, 'the number -1'],
      [Infinity, 'the number Infinity'],
      ['auto', 'the text "auto"'],
    ])
      throwsWarpError(
        () => bakeWarp(triangle(), twist, { detail }),
        new RegExp(`^bakeWarp: expected a number above 0 for the option "detail", got ${got}`),
      )
    throwsWarpError(() => bakeWarp(triangle(), twist, { detial: 1 }), /there is no option "detial"/)
  })

  test('warps positions and normals, and keeps the rest', () => {
    const mesh = { ...sphere(), material }
    const before = structuredClone(mesh)
    const baked = bakeWarp(mesh, twist)
    assert.deepEqual(mesh, before, 'the input was changed')
    for (const name of ['uvs', 'colors', 'indices', 'material'])
      assert.deepEqual(baked[name], mesh[name], name)
    assert.notEqual(baked.uvs, mesh.uvs)
    // The twist about y is p' = R(2y) p. At the equator's first vertex, (1, 0, 0), it tilts the surface by exactly atan(2): the
    // tangent (0, 1, 0) becomes (0, 1, -2), and (0, 0, 1) stays as it is.
    for (let v = 0; v < mesh.positions.length / 3; v++) {
      const [x, y, z] = mesh.positions.subarray(3 * v, 3 * v + 3)
      const [c, s] = [Math.cos(2 * y), Math.sin(2 * y)]
      const expected = [c * x + s * z, y, c * z - s * x]
      expected.forEach((value, i) => assert.ok(Math.abs(baked.positions[3 * v + i] - value) < 1e-6))
    }
    const v = mesh.positions.findIndex(
      (x, i) => i % 3 === 0 && x === 1 && Math.abs(mesh.positions[i + 1]) < 1e-6,
    )
    const normal = baked.normals.subarray(v, v + 3)
    for (const tangent of [
      [0, 1, -2],
      [0, 0, 1],
    ]) {
      const dot = tangent.reduce((sum, x, i) => sum + x * normal[i], 0)
      assert.ok(Math.abs(dot) < 1e-5, `${normal} is not at right angles to ${tangent}`)
    }
    assert.equal(baked.tangents.length, mesh.tangents.length)
  })

  test('uses uniforms', () => {
    const baked = bakeWarp(triangle(), rise, { uniforms: { millis: 5 } })
    assert.deepEqual([...baked.positions], [0, 5, 0, 1, 5, 0, 0, 6, 0])
    throwsWarpError(() => bakeWarp(triangle(), rise), /^bakeWarp: the warp reads "millis"/)
    throwsWarpError(
      () => bakeWarp(triangle(), rise, { uniforms: { milis: 5 } }),
      /^bakeWarp: the warp has no uniform "milis"/,
    )
  })

  test('computes missing normals first', () => {
    const { positions } = triangle()
    assert.deepEqual(
      [...bakeWarp({ positions }, rise, { uniforms: { millis: 1 } }).normals],
      [0, 0, 1, 0, 0, 1, 0, 0, 1],
    )
  })

  test('returns an empty mesh for an empty mesh', () => {
    assert.equal(bakeWarp({ positions: [] }, twist).positions.length, 0)
  })

  test('rejects warps without a finite result', () => {
    const pole = compileWarp(({ glsl, position }) => glsl.vec3(position.x().sub(1).pow(-1), 0, 0))
    throwsWarpError(
      () => bakeWarp(triangle(), pole),
      /^bakeWarp: expected a finite position of vertex 1 at \(1, 0, 0\), got Infinity/,
    )
  })

  test('rejects invalid warps', () => {
    for (const warp of [undefined, 7, {}, () => 1])
      throwsWarpError(
        () => bakeWarp(triangle(), warp),
        /^bakeWarp: expected a result of compileWarp for the warp, got /,
      )
    const withoutNormals = compileWarp(({ position }) => position, { normals: false })
    throwsWarpError(
      () => bakeWarp(triangle(), withoutNormals),
      /^bakeWarp: the warp was compiled with "normals: false"/,
    )
  })

  test('returns a mesh that can be exported and loaded again', async () => {
    const loaded = await loadMesh(exportGLB(bakeWarp(sphere(), twist)))
    assert.deepEqual(loaded.positions, bakeWarp(sphere(), twist).positions)
  })
})
