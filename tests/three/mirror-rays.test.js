// A ray hits an object that a warp mirrors where it hits the same object mirrored by its matrix.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { warp as warpObject } from 'warpjet/three'
import { byUniform, mirror } from '../support/mirrors.js'

describe('rays of three.js', () => {
  const offsets = { 'a mirror': [mirror, {}], 'by a uniform': [byUniform, { scale: -1 }] }
  const sides = {
    FrontSide: THREE.FrontSide,
    BackSide: THREE.BackSide,
    DoubleSide: THREE.DoubleSide,
  }

  /** Makes an asymmetric mesh, and the same mesh mirrored by its matrix. */
  function makePair(side) {
    const geometry = new THREE.ConeGeometry(0.7, 1.4, 24, 6).rotateZ(0.6).translate(0.3, 0, 0)
    const [mesh, other] = [0, 1].map(
      () => new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side })),
    )
    other.scale.x = -1
    for (const object of [mesh, other]) object.updateMatrixWorld(true)
    return [mesh, other]
  }

  const rays = Array.from({ length: 40 }, (_, i) => {
    const from = new THREE.Vector3(3 * Math.cos(i), 2 * Math.sin(3 * i), 3 * Math.sin(i))
    const target = new THREE.Vector3(-0.3 + 0.3 * Math.sin(5 * i), 0.4 * Math.cos(7 * i), 0)
    return new THREE.Raycaster(from, target.sub(from).normalize())
  })

  for (const [name, [offset, uniforms]] of Object.entries(offsets))
    for (const space of ['local', 'rest', 'world'])
      for (const [sideName, side] of Object.entries(sides))
        test(`${name}, ${space}, ${sideName}`, () => {
          const [mesh, other] = makePair(side)
          const warped = warpObject(mesh, offset, { space, uniforms })
          let count = 0
          for (const ray of rays) {
            const [hits, expected] = [ray.intersectObject(mesh), ray.intersectObject(other)]
            assert.equal(hits.length, expected.length)
            hits.forEach(({ point, face, normal, faceIndex }, i) => {
              count++
              assert.equal(faceIndex, expected[i].faceIndex)
              assert.ok(point.distanceTo(expected[i].point) < 1e-5)
              // Face normals are in the local space of `other`, to which its mirroring matrix is not applied yet.
              const mirrorX = (v) => v.clone().set(-v.x, v.y, v.z)
              assert.ok(face.normal.distanceTo(mirrorX(expected[i].face.normal)) < 1e-4)
              assert.ok(normal.normalize().angleTo(mirrorX(expected[i].normal)) < 1e-3)
            })
          }
          assert.ok(count > 20, `${count} hits`)
          warped.dispose()
        })

  test('in world space, rays hit an object that its matrix mirrors', () => {
    const [mesh, other] = makePair(THREE.FrontSide)
    const [, mirroredByMatrix] = makePair(THREE.FrontSide)
    other.scale.x = 1
    other.updateMatrixWorld(true)
    mesh.scale.x = -1
    mesh.updateMatrixWorld(true)
    for (const [offset, expected] of [
      [mirror, other],
      [({ glsl }) => glsl.vec3(0, 0, 0), mirroredByMatrix],
    ]) {
      const warped = warpObject(mesh, offset, { space: 'world' })
      for (const ray of rays) {
        const [hits, expectedHits] = [ray.intersectObject(mesh), ray.intersectObject(expected)]
        assert.deepEqual(
          hits.map(({ faceIndex }) => faceIndex),
          expectedHits.map(({ faceIndex }) => faceIndex),
        )
      }
      warped.dispose()
    }
  })
})
