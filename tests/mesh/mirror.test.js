// Tests meshes that are baked with warps that mirror space: the outer side of a closed surface stays outside.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { twist } from 'warpjet/deformers'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { assertOutside, mirror, round, volumeOf } from '../support/mirrors.js'

describe('bakeWarp with a mirror', () => {
  const warp = compileWarp(mirror)

  test('keeps the order of vertices without indices, and adds indices that reverse the triangles', () => {
    const flat = (numbers, size) =>
      Float32Array.from(round.indices).reduce(
        (all, i, at) => (all.set(numbers.subarray(size * i, size * i + size), size * at), all),
        new Float32Array(size * round.indices.length),
      )
    const soup = { positions: flat(round.positions, 3), normals: flat(round.normals, 3) }
    const baked = bakeWarp(soup, warp)
    assertOutside(baked, 'soup')
    assert.equal(baked.positions.length, soup.positions.length)
    soup.positions.forEach((x, i) => assert.ok(baked.positions[i] === (i % 3 ? x : -x)))
    assert.deepEqual([...baked.indices.slice(0, 6)], [0, 2, 1, 3, 5, 4])
    assert.equal(bakeWarp(soup, compileWarp(twist({ angle: 1, length: 1 }))).indices, undefined)
  })

  test('leaves an empty mesh empty', () => {
    const baked = bakeWarp({ positions: [] }, warp)
    assert.equal(baked.positions.length, 0)
  })

  test('computes missing normals first', () => {
    const { positions, indices } = round
    assertOutside(bakeWarp({ positions, indices }, warp), 'computed')
  })

  test('returns a mesh whose outer side stays outside after exporting and loading', async () => {
    const mesh = await loadMesh(exportGLB(bakeWarp(round, warp)))
    assertOutside(mesh, 'from the file')
  })

  test('bakes a mesh that is subdivided for the warp', () => {
    const finer = subdivide(round, { warp, tolerance: 0.002 })
    assert.ok(volumeOf(finer) > 0, 'the subdivided mesh is inside out')
    assertOutside(bakeWarp(finer, warp), 'subdivided')
  })

  test('bakes three.js geometries with groups and morph targets, indexed and not indexed', () => {
    for (const geometry of [
      new THREE.BoxGeometry(1, 1, 1, 8, 8, 8),
      new THREE.BoxGeometry(1, 1, 1, 8, 8, 8).toNonIndexed(),
    ]) {
      geometry.morphAttributes.position = [geometry.attributes.position.clone()]
      const baked = bakeWarp(geometry, warp)
      assert.deepEqual(baked.groups, geometry.groups)
      const mesh = {
        positions: baked.attributes.position.array,
        normals: baked.attributes.normal.array,
        indices: baked.index.array,
      }
      assertOutside(mesh, geometry.index ? 'indexed' : 'not indexed')
      const twisted = bakeWarp(geometry, compileWarp(twist({ angle: 1, length: 1 })))
      assert.deepEqual(twisted.index, geometry.index)
    }
  })

  test('does not reverse triangles for an object with an evaluate method', () => {
    const byHand = { evaluate: ({ positions, normals }) => ({ positions, normals }) }
    assert.deepEqual(bakeWarp(round, byHand).indices, round.indices)
  })
})
