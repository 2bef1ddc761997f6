// Rays hit warped surfaces where they are drawn.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { MeshBVH, acceleratedRaycast, computeBatchedBoundsTree } from 'three-mesh-bvh'
import { compileWarp } from 'warpjet'
import { bend, bulge, shear, spherify, stretch, taper, twist } from 'warpjet/deformers'
import { bakeWarp } from 'warpjet/mesh'
import { addSurfaceVariation, warp } from 'warpjet/three'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { plane, randomNumbers, rayFrom, transform, wave } from '../support/three-meshes.js'

/** Makes an unwarped mesh whose vertices `move(x, y, z)` moves in double precision. */
function makeReference(mesh, move, instance = new THREE.Matrix4()) {
  const geometry = mesh.geometry.toNonIndexed()
  const { position } = geometry.attributes
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)]
    position.setXYZ(i, ...move(x, y, z))
  }
  geometry.computeBoundingSphere()
  const reference = new THREE.Mesh(geometry, mesh.material)
  reference.matrixWorld.multiplyMatrices(mesh.matrixWorld, instance)
  return reference
}

/** Asserts that rays hit a mesh at the same points as the references, or hit neither. */
function assertSameHits(
  mesh,
  references,
  { rays = 200, spread = 1.5, random = randomNumbers() } = {},
) {
  let hits = 0
  for (let i = 0; i < rays; i++) {
    const ray = rayFrom(random, new THREE.Vector3(0.3, -0.2, 0.1), spread)
    const found = ray.intersectObject(mesh)
    const expected = references.flatMap((reference) => ray.intersectObject(reference, false))
    expected.sort((a, b) => a.distance - b.distance)
    assert.equal(found.length, expected.length, `ray ${i}`)
    found.forEach((hit, k) => {
      assert.ok(
        hit.point.distanceTo(expected[k].point) < 1e-4,
        `ray ${i}: ${hit.distance} and ${expected[k].distance}`,
      )
      assert.equal(hit.object, mesh)
    })
    hits += found.length
  }
  assert.ok(hits > rays / 5, `${hits} hits`)
}

describe('rays hit the warped surface', () => {
  const height = 0.3
  const moveAt = (millis) => (x, y, z) => [x, y, z + height * Math.sin(3 * x + millis / 500)]

  test('of a mesh, also after uniforms change', () => {
    const mesh = transform(plane())
    const warped = warp(mesh, wave, { uniforms: { height } })
    // The last time is after a week.
    for (const millis of [0, 700, 6e8 + 700]) {
      warped.update(millis)
      assertSameHits(mesh, [makeReference(mesh, moveAt(millis))])
    }
    warped.uniforms.height.value = 0
    assertSameHits(mesh, [makeReference(mesh, (...point) => point)])
    warped.dispose()
    assertSameHits(mesh, [makeReference(mesh, (...point) => point)])
  })

  test('of instances, and report the instanceId', () => {
    const { geometry, material } = plane()
    const mesh = transform(new THREE.InstancedMesh(geometry, material, 3))
    const matrices = [0, 1, 2].map((i) =>
      new THREE.Matrix4().compose(
        new THREE.Vector3(i - 1, 0.3 * i, 0),
        new THREE.Quaternion().setFromEuler(new THREE.Euler(i, 0.5, 0)),
        new THREE.Vector3(0.5, 0.4 + 0.2 * i, 0.6),
      ),
    )
    matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
    const warped = warp(mesh, wave, { uniforms: { height } })
    assertSameHits(
      mesh,
      matrices.map((matrix) => makeReference(mesh, moveAt(0), matrix)),
    )
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0, 9), new THREE.Vector3(0, 0, -1))
    for (const hit of ray.intersectObject(mesh)) assert.ok(hit.instanceId in matrices)
    warped.dispose()
  })

  test('in world space, of a mesh and of instances', () => {
    const offset = ({ glsl, position }) => glsl.vec3(0, position.x().mult(3).sin().mult(0.3), 0)
    const makeReferenceInWorld = (mesh, instance = new THREE.Matrix4()) => {
      const toWorld = new THREE.Matrix4().multiplyMatrices(mesh.matrixWorld, instance)
      const reference = makeReference(mesh, (x, y, z) => {
        const point = new THREE.Vector3(x, y, z).applyMatrix4(toWorld)
        return [point.x, point.y + 0.3 * Math.sin(3 * point.x), point.z]
      })
      reference.matrixWorld.identity()
      return reference
    }
    const mesh = transform(plane())
    warp(mesh, offset, { space: 'world' })
    assertSameHits(mesh, [makeReferenceInWorld(mesh)])
    const instanced = transform(new THREE.InstancedMesh(mesh.geometry, mesh.material, 2))
    const matrices = [
      new THREE.Matrix4().makeTranslation(1, 0, 0),
      new THREE.Matrix4().makeScale(0.5, 1, 1),
    ]
    matrices.forEach((matrix, i) => instanced.setMatrixAt(i, matrix))
    instanced.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
    warp(instanced, offset, { space: 'world' })
    assertSameHits(
      instanced,
      matrices.map((matrix) => makeReferenceInWorld(instanced, matrix)),
    )
  })

  test('of points and lines', () => {
    const { geometry } = plane()
    const points = new THREE.Points(geometry, new THREE.PointsMaterial())
    const line = new THREE.Line(geometry, new THREE.LineBasicMaterial())
    const up = ({ glsl }) => glsl.vec3(0, 0, 5)
    const ray = new THREE.Raycaster(new THREE.Vector3(0.5, -9, 5), new THREE.Vector3(0, 1, 0))
    ray.params.Points.threshold = ray.params.Line.threshold = 0.01
    for (const object of [points, line]) {
      assert.equal(ray.intersectObject(object).length, 0)
      warp(object, up)
      const [hit] = ray.intersectObject(object)
      assert.equal(hit.object, object)
      assert.ok(Math.abs(hit.point.z - 5) < 0.011)
    }
  })

  test('with three-mesh-bvh, assigned before the warp or after it, also of a batch', () => {
    const up = ({ glsl }) => glsl.vec3(0, 0, 2)
    const down = new THREE.Raycaster(new THREE.Vector3(0.2, 0.1, 9), new THREE.Vector3(0, 0, -1))
    const height = (object) => down.intersectObject(object)[0].point.z
    for (const when of ['before', 'after']) {
      const mesh = plane()
      mesh.geometry.boundsTree = new MeshBVH(mesh.geometry)
      if (when === 'before') mesh.raycast = acceleratedRaycast
      const warped = warp(mesh, up)
      if (when === 'after') mesh.raycast = acceleratedRaycast
      assert.ok(Math.abs(height(mesh) - 2) < 1e-4, when)
      warped.dispose()
      assert.equal(mesh.raycast, acceleratedRaycast)
      assert.ok(Math.abs(height(mesh)) < 1e-4)
    }
    for (const space of ['local', 'world']) {
      const batch = new THREE.BatchedMesh(1, 8, 12, new THREE.MeshBasicMaterial())
      const id = batch.addGeometry(new THREE.PlaneGeometry(2, 2))
      batch.setMatrixAt(batch.addInstance(id), new THREE.Matrix4())
      computeBatchedBoundsTree.call(batch)
      batch.raycast = acceleratedRaycast
      warp(batch, up, { space })
      assert.ok(Math.abs(height(batch) - 2) < 1e-4, space)
    }
  })

  test('but miss a warp that only the GPU can evaluate, with one warning', (t) => {
    const warn = t.mock.method(console, 'warn', () => {})
    const mesh = plane()
    const map = new THREE.DataTexture(new Uint8Array(4), 1, 1)
    const warped = warp(mesh, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
      uniforms: { map },
      surfaceVariation: false,
    })
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0, 9), new THREE.Vector3(0, 0, -1))
    assert.equal(ray.intersectObject(mesh).length + ray.intersectObject(mesh).length, 0)
    assert.equal(warn.mock.callCount(), 1)
    assert.match(warn.mock.calls[0].arguments[0], /^warp: rays miss a warp that/)
    assert.equal(mesh.boundingSphere.radius, Infinity)
    warped.dispose()
  })
})

describe('in world space, rays hit a warped object at the same points, and with the same normals, as a geometry in world coordinates:', () => {
  const offsets = {
    'along the normal': ({ glsl, normal, position }) =>
      normal.mult(position.x().mult(3).sin().mult(0.2)).add(glsl.vec3(0, 0, 0.1)),
    'by uv': ({ normal, uv }) => normal.mult(uv.x().mult(20).sin().mult(0.1)),
  }
  const rotation = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(0.7, -1.1, 0.4))
  const stretched = rotation
    .clone()
    .multiply(new THREE.Matrix4().makeScale(1.5, 0.8, 2))
    .setPosition(1, 2, -1)

  function compare(transformed, inWorld, offset) {
    transformed.updateMatrixWorld(true)
    warp(transformed, offset, { space: 'world' })
    warp(inWorld, offset)
    const toWorld = new THREE.Matrix3().getNormalMatrix(transformed.matrixWorld)
    const random = randomNumbers(7)
    let count = 0
    for (let i = 0; i < 60; i++) {
      const ray = rayFrom(random, transformed.position, 1)
      const [[a], [b]] = [ray.intersectObject(transformed), ray.intersectObject(inWorld)]
      assert.equal(a === undefined, b === undefined)
      if (!a) continue
      count++
      assert.ok(a.point.distanceTo(b.point) < 1e-4)
      const angle = a.normal.clone().applyMatrix3(toWorld).normalize().angleTo(b.normal)
      assert.ok(angle < 2e-3, `${angle}`)
    }
    assert.ok(count > 20)
  }

  for (const [name, offset] of Object.entries(offsets))
    test(`${name}, rotated and scaled`, async () => {
      const matrix = rotation
        .clone()
        .scale(new THREE.Vector3(2, 2, 2))
        .setPosition(1, 2, -1)
      const geometry = new THREE.TorusKnotGeometry(1, 0.4, 120, 24)
      const inWorld = await addSurfaceVariation(geometry.clone().applyMatrix4(matrix))
      const transformed = new THREE.Mesh(await addSurfaceVariation(geometry))
      transformed.applyMatrix4(matrix)
      compare(transformed, new THREE.Mesh(inWorld), offset)
    })

  test('along the normal of an ellipsoid, whose normals and gradients have formulas', () => {
    const geometry = new THREE.SphereGeometry(1, 80, 60)
    const inWorld = geometry.clone().applyMatrix4(stretched)
    const back = new THREE.Matrix3().setFromMatrix4(stretched).invert()
    // With q relative to the center, the ellipsoid is q · S q = 1 with S = B^T B, where B is `back`. Its normal is S q / |S q|.
    const shape = back.clone().transpose().multiply(back)
    const center = new THREE.Vector3().setFromMatrixPosition(stretched)
    addGradients(geometry, new THREE.Matrix3(), new THREE.Vector3())
    addGradients(inWorld, shape, center)
    const transformed = new THREE.Mesh(geometry)
    transformed.matrixAutoUpdate = false
    transformed.matrix.copy(stretched)
    transformed.position.copy(center)
    compare(transformed, new THREE.Mesh(inWorld), offsets['along the normal'])
  })
})

/** Adds the gradients of the normal of the surface q · S q = 1, where `shape` is S; their formula was derived by hand. */
function addGradients(geometry, shape, center) {
  const { position } = geometry.attributes
  const gradients = [0, 1, 2].map(() => new Float32Array(3 * position.count))
  for (let i = 0; i < position.count; i++) {
    const q = new THREE.Vector3().fromBufferAttribute(position, i).sub(center)
    const normal = q.applyMatrix3(shape)
    const length = normal.length()
    normal.divideScalar(length)
    const project = (v) => v.addScaledVector(normal, -normal.dot(v))
    // The k-th row of (1 - n n^T) S (1 - n n^T) / |S q|.
    for (let k = 0; k < 3; k++) {
      const axis = project(new THREE.Vector3().setComponent(k, 1)).applyMatrix3(shape)
      project(axis)
        .divideScalar(length)
        .toArray(gradients[k], 3 * i)
    }
  }
  ;['X', 'Y', 'Z'].forEach((axis, k) =>
    geometry.setAttribute(
      `aWarpjet_normal${axis}Gradient`,
      new THREE.BufferAttribute(gradients[k], 3),
    ),
  )
}

const tenWarps = [
  twist({ axis: 'y', length: 2, angle: 1.5 }),
  bend({ axis: 'z', from: -1, to: 1, angle: 1.2 }),
  taper({ axis: 'y', length: 2, amount: 0.4 }),
  bulge({ radius: 1, amount: 0.5 }),
  stretch({ axis: 'x', amount: 1.6 }),
  shear({ axis: 'y', direction: 'x', amount: 0.4 }),
  spherify({ amount: 0.7, radius: 1 }),
  ({ position }) => position.mult(2).noise().mult(position).mult(0.4),
  ({ glsl, position }) => glsl.vec3(position.y().mult(5).sin().mult(0.2), 0, 0),
  ({ normal }) => normal.mult(0.3),
]

/** The number of rays per warp. */
const rayCount = isRun('a thousand rays') ? 1000 : 100

test('rays hit each of ten warps where they hit the baked mesh', () => {
  const { min, max } = Math
  const geometry = new THREE.TorusKnotGeometry(0.7, 0.25, 64, 12)
  const random = randomNumbers(3)
  for (const [i, offset] of tenWarps.entries()) {
    const mesh = transform(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial()))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const compiled = compileWarp(offset, { surfaceVariation: false })
    const reference = new THREE.Mesh(bakeWarp(geometry, compiled), mesh.material)
    reference.matrixWorld.copy(mesh.matrixWorld)
    const { array } = reference.geometry.attributes.position
    assert.ok(max(...array) - min(...array) < 20, `warp ${i}`)
    assertSameHits(mesh, [reference], { rays: rayCount, random })
    warped.dispose()
  }
})

test('rays hit each of ten warps where they hit a denser baked mesh, within 1e-4 of its size', (t) => {
  const random = randomNumbers(5)
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
  const makePatch = (columns, rows) => new THREE.SphereGeometry(1, columns, rows, 0, 2, 0.5, 1.4)
  const [fine, finer] = [makePatch(170, 120), makePatch(340, 240)]
  const randomVector = () => new THREE.Vector3(random(), random(), random()).subScalar(0.5)
  let worst = 0
  for (const offset of tenWarps) {
    const mesh = transform(new THREE.Mesh(fine, material))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const baked = bakeWarp(finer, compileWarp(offset, { surfaceVariation: false }))
    baked.boundsTree = new MeshBVH(baked)
    const dense = new THREE.Mesh(baked, material)
    dense.raycast = acceleratedRaycast
    dense.matrixWorld.copy(mesh.matrixWorld)
    const size = warped.bounds().getSize(new THREE.Vector3()).length()
    const { position, normal } = baked.attributes
    for (let i = 0; i < rayCount / 10; i++) {
      // Casts a ray from a random point above the surface to a vertex that is not near the edge.
      const [u, v] = [0.1 + 0.8 * random(), 0.1 + 0.8 * random()]
      const vertex = Math.round(340 * u) + 341 * Math.round(240 * v)
      const to = new THREE.Vector3()
        .fromBufferAttribute(position, vertex)
        .add(randomVector().multiplyScalar(1e-3))
      const from = new THREE.Vector3()
        .fromBufferAttribute(normal, vertex)
        .add(randomVector())
        .multiplyScalar(3)
        .add(to)
      for (const point of [to, from]) point.applyMatrix4(mesh.matrixWorld)
      const ray = new THREE.Raycaster(from, to.sub(from).normalize())
      const [found] = ray.intersectObject(mesh)
      const [expected] = ray.intersectObject(dense)
      worst = Math.max(worst, found.point.distanceTo(expected.point) / size)
    }
    warped.dispose()
  }
  t.diagnostic(`at most ${worst.toExponential(1)} of the size of the mesh`)
  assert.ok(worst < 1e-4, `${worst} of the size of the mesh`)
})

test('bounds and rays follow the visibility of batch instances and the draw range of a geometry', () => {
  const batch = new THREE.BatchedMesh(2, 8, 12, new THREE.MeshStandardMaterial())
  const geometry = batch.addGeometry(new THREE.PlaneGeometry(1, 1))
  const [near, far] = [0, 5].map((x) => {
    const id = batch.addInstance(geometry)
    batch.setMatrixAt(id, new THREE.Matrix4().makeTranslation(x, 0, 0))
    return id
  })
  batch.setVisibleAt(far, false)
  const up = ({ glsl }) => glsl.vec3(0, 0, 2)
  const warped = warp(batch, up)
  const ray = new THREE.Raycaster(new THREE.Vector3(5, 0, 9), new THREE.Vector3(0, 0, -1))
  assert.ok(warped.bounds().max.x < 1)
  assert.equal(ray.intersectObject(batch).length, 0)
  batch.setVisibleAt(far, true)
  assert.ok(warped.bounds().max.x >= 5.5)
  assert.equal(ray.intersectObject(batch)[0].batchId, far)
  batch.setVisibleAt(near, false)
  assert.ok(warped.bounds().min.x > 4)
  warped.dispose()

  const mesh = plane()
  const { index } = mesh.geometry
  mesh.geometry.setDrawRange(0, 3)
  const partlyDrawn = warp(mesh, up)
  const down = new THREE.Raycaster(new THREE.Vector3(), new THREE.Vector3(0, 0, -1))
  const countHits = () => {
    let count = 0
    for (const x of [-0.9, 0.9])
      for (const y of [-0.9, 0.9]) {
        down.ray.origin.set(x, y, 9)
        count += down.intersectObject(mesh).length
      }
    return count
  }
  const before = countHits()
  mesh.geometry.setDrawRange(0, index.count)
  assert.ok(countHits() > before, `${before} hits of four before, ${countHits()} after`)
  partlyDrawn.dispose()
})
