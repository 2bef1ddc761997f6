// Bounds of warped objects, and culling by them.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import {
  makeMorphingMesh,
  makeSkinnedMesh,
  plane,
  randomNumbers,
  wave,
} from '../support/three-meshes.js'

test('culling never hides anything visible in ten thousand settings, and draws few invisible objects', (t) => {
  const random = randomNumbers(7)
  const { geometry, material } = plane()
  const kinds = [
    () => plane(),
    () => new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12), material),
    () => {
      const mesh = new THREE.InstancedMesh(geometry, material, 2)
      mesh.setMatrixAt(0, new THREE.Matrix4().makeTranslation(1, 1, 0))
      mesh.setMatrixAt(1, new THREE.Matrix4().makeScale(0.5, 0.2, 1))
      return mesh
    },
    makeBatch,
    makeSkinnedMesh,
    makeMorphingMesh,
  ]
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 30)
  const frustum = new THREE.Frustum()
  let [drawn, visible, settings, drawnInBatch, visibleInBatch] = [0, 0, 0, 0, 0]
  for (const space of ['local', 'world', 'rest'])
    for (const kind of kinds) {
      const mesh = kind()
      const warped = warp(mesh, wave, { space, uniforms: { height: 0 } })
      for (let i = 0; i < 57; i++) {
        warped.uniforms.height.value = 2 * random()
        mesh.userData.millis = 5000 * random()
        warped.update(mesh.userData.millis)
        mesh.position.set(random(), random(), random())
        mesh.rotation.set(6 * random(), 6 * random(), 6 * random())
        mesh.scale.setScalar(0.5 + random())
        for (const bone of mesh.skeleton?.bones ?? [])
          bone.rotation.set(random(), random(), random())
        if (mesh.morphTargetInfluences) mesh.morphTargetInfluences[0] = random()
        mesh.updateMatrixWorld(true)
        const instances = warpedVertices(mesh, space, warped)
        for (let k = 0; k < 10; k++) {
          settings++
          camera.position.set(random() - 0.5, random() - 0.5, random() - 0.5).multiplyScalar(12)
          camera.rotation.set(6 * random(), 6 * random(), 6 * random())
          camera.updateMatrixWorld()
          frustum.setFromProjectionMatrix(
            new THREE.Matrix4().multiplyMatrices(
              camera.projectionMatrix,
              camera.matrixWorldInverse,
            ),
          )
          const seen = instances.map((points) =>
            points.some((point) => frustum.containsPoint(point)),
          )
          const isDrawn = frustum.intersectsObject(mesh)
          assert.ok(isDrawn || !seen.includes(true), `${space}, ${mesh.type}: culled`)
          if (!mesh.isBatchedMesh) {
            drawn += isDrawn
            visible += seen.includes(true)
            continue
          }
          const drawnHere = isDrawn ? drawnInstances(mesh, camera) : []
          seen.forEach((isSeen, i) =>
            assert.ok(!isSeen || drawnHere.includes(i), `${space}: ${i} culled`),
          )
          drawnInBatch += drawnHere.length
          visibleInBatch += seen.filter(Boolean).length
        }
      }
    }
  assert.ok(settings > 10_000)
  t.diagnostic(`${settings} settings: ${drawn} drawn, ${visible} visible`)
  t.diagnostic(`in batches: ${drawnInBatch} instances drawn, ${visibleInBatch} visible`)
  assert.ok(visible > 500 && drawn <= 2 * visible)
  assert.ok(visibleInBatch > 100 && drawnInBatch <= 2 * visibleInBatch)
})

test('a skinned mesh is culled by boxes of its bones, without posing its vertices', () => {
  const mesh = makeSkinnedMesh()
  warp(mesh, wave, { uniforms: { height: 0.1 } })
  mesh.updateMatrixWorld(true)
  mesh.getVertexPosition = () => assert.fail('a vertex was posed')
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 30)
  camera.position.z = 5
  camera.updateMatrixWorld()
  const frustum = new THREE.Frustum().setFromProjectionMatrix(
    new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
  )
  assert.ok(frustum.intersectsObject(mesh))
})

/** Makes a batch of two balls and two rings. */
function makeBatch() {
  const geometries = [
    new THREE.SphereGeometry(1.2, 24, 16),
    new THREE.TorusGeometry(1, 0.4, 12, 32),
  ]
  const [vertices, indices] = ['position', 'index'].map((name) =>
    geometries.reduce(
      (sum, geometry) => sum + (geometry[name] ?? geometry.attributes[name]).count,
      0,
    ),
  )
  const mesh = new THREE.BatchedMesh(4, vertices, indices, new THREE.MeshBasicMaterial())
  const ids = geometries.map((geometry) => mesh.addGeometry(geometry))
  for (const [i, x] of [-3, -1, 1, 3].entries())
    mesh.setMatrixAt(
      mesh.addInstance(ids[i % 2]),
      new THREE.Matrix4()
        .makeRotationY(i)
        .scale(new THREE.Vector3(1, 0.7, 0.9))
        .setPosition(x, i, 0),
    )
  return mesh
}

/** Lists the instances of a batch that three.js draws for a camera. */
function drawnInstances(mesh, camera) {
  mesh.onBeforeRender({}, undefined, camera, mesh.geometry, mesh.material)
  return [...mesh._indirectTexture.image.data.slice(0, mesh._multiDrawCount)]
}

/** Returns the vertices of each instance in world space, computed in double precision. */
function warpedVertices(mesh, space, { uniforms }) {
  const height = uniforms.height.value
  const { millis } = mesh.userData
  const lift = (point) => {
    point.z += height * Math.sin(3 * point.x + millis / 500)
    return point
  }
  const hasInstances = mesh.isInstancedMesh || mesh.isBatchedMesh
  const posed = space === 'rest' ? withLifted(mesh, lift) : mesh
  return Array.from(
    { length: hasInstances ? (mesh.instanceCount ?? mesh.count) : 1 },
    (_, instance) => {
      const matrix = new THREE.Matrix4()
      if (hasInstances) mesh.getMatrixAt(instance, matrix)
      const { vertexStart = 0, vertexCount = mesh.geometry.attributes.position.count } =
        mesh.isBatchedMesh ? mesh.getGeometryRangeAt(mesh.getGeometryIdAt(instance)) : {}
      return Array.from({ length: vertexCount }, (_, i) => {
        const point = posed.getVertexPosition(vertexStart + i, new THREE.Vector3())
        if (space === 'local') lift(point)
        point.applyMatrix4(matrix).applyMatrix4(mesh.matrixWorld)
        return space === 'world' ? lift(point) : point
      })
    },
  )
}

/** Returns an object that inherits from the mesh, with a geometry that is lifted before morph targets and bones apply. */
function withLifted(mesh, lift) {
  const position = mesh.geometry.attributes.position.clone()
  for (let i = 0; i < position.count; i++) {
    const { x, y, z } = lift(new THREE.Vector3().fromBufferAttribute(position, i))
    position.setXYZ(i, x, y, z)
  }
  const attributes = { ...mesh.geometry.attributes, position }
  const geometry = Object.create(mesh.geometry, { attributes: { value: attributes } })
  return Object.create(mesh, { geometry: { value: geometry } })
}

test('a sphere around the corners of a box has room for the sines of a GPU', () => {
  // WGSL, section 15.7.4: the absolute error of a sine from -pi to pi is at most 2^-11.
  const reach = 3 * (1 + 2 ** -11)
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(2, 2, 2))
  const warped = warp(mesh, ({ position }) =>
    position
      .mult(Math.PI / 2)
      .sin()
      .mult(3)
      .sub(position),
  )
  assert.ok(mesh.boundingSphere.containsPoint(new THREE.Vector3(reach, reach, reach)))
  assert.ok(mesh.boundingSphere.radius < 1.01 * Math.hypot(3, 3, 3))
  warped.dispose()
})

test('bounds() contains the drawn object, and all parts of a group', () => {
  const [left, right] = [plane(), plane()]
  left.position.x = -3
  right.position.x = 3
  const group = new THREE.Group().add(left, right)
  group.updateMatrixWorld(true)
  const warped = warp(group, ({ glsl }) => glsl.vec3(0, 0, 2))
  const { min, max } = warped.bounds()
  for (const [k, expected] of [-4, -1, 2].entries())
    assert.ok(Math.abs(min.toArray()[k] - expected) < 1e-4)
  for (const [k, expected] of [4, 1, 2].entries())
    assert.ok(Math.abs(max.toArray()[k] - expected) < 1e-4)
  warped.dispose()
})
