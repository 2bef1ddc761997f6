// bakeWarp: moves positions, normals and tangents, and checks its arguments.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import { checkMemoryAfterEach, material, rise, twist } from '../support/mesh-tests.js'
import { sphere, triangle } from '../support/meshes.js'
import { throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('bakeWarp', () => {
  test('warps positions and normals, and keeps the rest', () => {
    const mesh = { ...sphere(), material }
    const before = structuredClone(mesh)
    const baked = bakeWarp(mesh, twist)
    assert.deepEqual(mesh, before, 'the input is unchanged')
    for (const name of ['uvs', 'colors', 'indices', 'material'])
      assert.deepEqual(baked[name], mesh[name], name)
    assert.notEqual(baked.uvs, mesh.uvs)
    // The twist about y, by hand: p' = R(2y) p; its normal by two finite differences of the sphere would do, but at the equator's
    // first vertex (1, 0, 0) the surface is tilted by exactly atan(2): the tangent (0, 1, 0) becomes (0, 1, -2).
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
      assert.ok(Math.abs(dot) < 1e-5, `${normal} is at right angles to ${tangent}`)
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
    const flat = compileWarp(({ position }) => position, { normals: false })
    throwsWarpError(
      () => bakeWarp(triangle(), flat),
      /^bakeWarp: the warp was compiled with "normals: false"/,
    )
  })

  test('exports a result that other programs can read', async () => {
    const again = await loadMesh(exportGLB(bakeWarp(sphere(), twist)))
    assert.deepEqual(again.positions, bakeWarp(sphere(), twist).positions)
  })
})
