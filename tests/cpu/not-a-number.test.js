// Tests results that are NaN or infinite, in each host that evaluates on the CPU: divisions by a uniform that is 0, and vertices without a
// finite position.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'
import { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/core/Culling/ray.js'
import * as THREE from 'three'
import { BabylonWarp } from '../../dist/babylon.js'
import { warp } from '../../dist/three.js'
import { compileWarp } from '../../dist/warpjet.js'

const beat = ({ glsl, position, millis, uniforms }) =>
  glsl.vec3(0, millis.div(uniforms.period).mult(0.001).add(position.x).sin(), 0)
const drift = ({ glsl, millis, uniforms }) => glsl.vec3(0, millis.div(uniforms.period), 0)

describe('a warp with frame constants', () => {
  const options = { perFrame: true, uniforms: { period: 0 } }

  test('does not mistake a division by 0 for a missing uniform', () => {
    for (const offset of [beat, drift])
      for (const millis of [0, 1200]) {
        const compiled = compileWarp(offset, options)
        const frame = Object.values(compiled.frameUniforms({ millis })).flat()
        assert.ok(frame.some((number) => !Number.isFinite(number)))
        const uniforms = { millis }
        const { position } = compiled.evaluateAt([1, 2, 3], { uniforms })
        assert.deepEqual([position[0], position[2]], [1, 3])
        assert.ok(!Number.isFinite(position[1]))
        assert.ok(
          !Number.isFinite(compiled.evaluate({ positions: [1, 2, 3] }, { uniforms }).positions[1]),
        )
        assert.equal(compiled.inverseAt([1, 2, 3], { uniforms }), undefined)
        assert.equal(compiled.foldover({ positions: [1, 2, 3] }, { uniforms }).mask.length, 1)
        const { min, max } = compiled.bounds({ min: [0, 0, 0], max: [1, 1, 1] }, { uniforms })
        assert.ok(min[0] <= 0 && max[0] >= 1 && min[2] <= 0 && max[2] >= 1)
      }
  })

  test('names a missing input in its message, whatever the other values are', () => {
    const compiled = compileWarp(beat, options)
    const missing = (method) => new RegExp(`^WarpError: ${method}: the warp reads "millis"`)
    assert.throws(() => compiled.frameUniforms({}), missing('frameUniforms'))
    assert.throws(() => compiled.bounds({ min: [0, 0, 0], max: [1, 1, 1] }), missing('bounds'))
    const pointed = compileWarp(
      ({ glsl, position, mouse, uniforms }) =>
        glsl.vec3(mouse.x.div(uniforms.period).add(position.x).sin(), 0, 0),
      options,
    )
    assert.throws(() => pointed.frameUniforms({ millis: 5 }), /the warp reads "mouse"/)
    assert.throws(() => pointed.evaluateAt([0, 0, 0]), /the warp reads "mouse"/)
  })

  test('a declared uniform can be passed to each method', () => {
    const compiled = compileWarp(
      ({ glsl, millis, uniforms: { isOn, center } }) =>
        glsl.vec3(center.x.mult(millis), isOn.mult(millis), 0),
      { perFrame: true, uniforms: { isOn: false, center: [1, 2] } },
    )
    const values = { millis: 3, isOn: true, center: { x: 5, y: 6, z: 0 } }
    assert.deepEqual(compiled.evaluateAt([0, 0, 0], { uniforms: values }).position, [15, 3, 0])
    assert.ok(Object.values(compiled.frameUniforms(values)).flat().includes(15))
  })
})

/** Returns whether three.js draws an object, rather than culling it. */
function isSeen(object) {
  const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 100)
  camera.position.z = 6
  camera.updateMatrixWorld(true)
  object.updateMatrixWorld(true)
  const view = new THREE.Matrix4().multiplyMatrices(
    camera.projectionMatrix,
    camera.matrixWorld.clone().invert(),
  )
  return new THREE.Frustum().setFromProjectionMatrix(view).intersectsObject(object)
}
const downwardRay = () =>
  new THREE.Raycaster(new THREE.Vector3(0.21, 0.13, 5), new THREE.Vector3(0, 0, -1))
const plane = () => new THREE.PlaneGeometry(2, 2, 8, 8)
const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
const lift = ({ glsl, position }) => glsl.vec3(0, 0, position.x.sin().mult(0.2))
const spaces = ['local', 'rest', 'world']

/** Sets the first component of an attribute to `value`. The component belongs to a vertex in a corner, far from the ray. */
function breakVertex(geometry, value, attribute = 'position') {
  geometry.attributes[attribute].array[0] = value
  return geometry
}

describe('three.js', () => {
  for (const space of spaces)
    test(`draws a warp that divides by 0, in the space ${space}, and rays still work`, () => {
      for (const offset of [beat, drift]) {
        const mesh = new THREE.Mesh(plane(), material)
        const warped = warp(mesh, offset, { space, uniforms: { period: 200 } })
        for (const [period, millis] of [
          [200, 0],
          [0, 0],
          [0, 1200],
          [-0, 1200],
        ]) {
          warped.uniforms.period.value = period
          warped.update(millis)
          assert.equal(isSeen(mesh), true)
          const hits = downwardRay().intersectObject(mesh)
          assert.ok(hits.length === 0 || period !== 0)
          warped.bounds()
        }
        warped.uniforms.period.value = 200
        warped.update(0)
        assert.equal(downwardRay().intersectObject(mesh).length, 1)
        warped.dispose()
      }
    })

  const objects = {
    mesh: (geometry) => new THREE.Mesh(geometry, material),
    points: (geometry) => new THREE.Points(geometry, new THREE.PointsMaterial()),
    line: (geometry) => new THREE.Line(geometry, new THREE.LineBasicMaterial()),
    instances(geometry) {
      const mesh = new THREE.InstancedMesh(geometry, material, 2)
      mesh.setMatrixAt(0, new THREE.Matrix4())
      mesh.setMatrixAt(1, new THREE.Matrix4().makeTranslation(5, 0, 0))
      return mesh
    },
    morphed(geometry) {
      geometry.morphAttributes.position = [geometry.attributes.position.clone()]
      const mesh = new THREE.Mesh(geometry, material)
      mesh.morphTargetInfluences = [0.5]
      return mesh
    },
  }
  for (const [kind, make] of Object.entries(objects))
    test(`a vertex of ${kind} without a finite position neither throws nor hides the others`, () => {
      for (const space of spaces)
        for (const value of [NaN, Infinity, -Infinity, 1e39]) {
          const object = make(breakVertex(plane(), value))
          const warped = warp(object, lift, { space })
          assert.equal(isSeen(object), true, `${value} ${space}`)
          const hits = downwardRay().intersectObject(object)
          if (object.isMesh) assert.equal(hits.length, 1, `${value} ${space}`)
          const { min, max } = warped.bounds()
          assert.ok(min.x === -Infinity && max.x === Infinity)
          warped.dispose()
        }
    })

  test('a vertex with a texture coordinate that is not finite, or in a batch without a finite position, neither throws nor hides the others', () => {
    const along = ({ glsl, position, uv }) => glsl.vec3(0, 0, uv.x.mult(0.1).add(position.x))
    const mesh = new THREE.Mesh(breakVertex(plane(), NaN, 'uv'), material)
    warp(mesh, along)
    assert.equal(isSeen(mesh), true)
    assert.equal(downwardRay().intersectObject(mesh).length, 1)
    for (const space of spaces) {
      const geometry = breakVertex(plane(), NaN)
      const batch = new THREE.BatchedMesh(2, 1000, 2000, material)
      batch.addInstance(batch.addGeometry(geometry))
      warp(batch, lift, { space })
      assert.equal(isSeen(batch), true)
      const sphere = batch.getBoundingSphereAt(0, new THREE.Sphere())
      assert.equal(sphere.radius, Infinity)
    }
  })

  test('the bounds of a group with a non-finite part are infinite, not NaN', () => {
    const group = new THREE.Group()
    group.add(
      new THREE.Mesh(plane(), material),
      new THREE.Mesh(breakVertex(plane(), NaN), material),
    )
    group.children[1].position.x = 3
    group.updateMatrixWorld(true)
    const { min, max } = warp(group, lift).bounds()
    assert.deepEqual(
      [...min.toArray(), ...max.toArray()],
      [...Array(3).fill(-Infinity), ...Array(3).fill(Infinity)],
    )
  })

  test('draws an object whose positions are all NaN on the CPU, since the GPU may compute finite ones', () => {
    const mesh = new THREE.Mesh(plane(), material)
    warp(mesh, ({ glsl, position }) => glsl.vec3(position.x.abs().add(1).neg().sqrt(), 0, 0))
    assert.equal(isSeen(mesh), true)
    assert.equal(downwardRay().intersectObject(mesh).length, 0)
  })
})

describe('Babylon.js', () => {
  const engine = new NullEngine()
  function sceneWith(offset, options) {
    const scene = new Scene(engine)
    const camera = new FreeCamera('camera', new Vector3(0, 0, -6), scene)
    camera.setTarget(Vector3.Zero())
    const mesh = MeshBuilder.CreateGround(
      'ground',
      { width: 2, height: 2, subdivisions: 6, updatable: true },
      scene,
    )
    mesh.material = new StandardMaterial('material', scene)
    const babylonWarp = new BabylonWarp(mesh.material, offset, options)
    return { scene, camera, mesh, babylonWarp }
  }
  const isDrawn = ({ scene, camera, mesh }) => {
    scene.updateTransformMatrix(true)
    camera.computeWorldMatrix()
    return camera.isInFrustum(mesh)
  }

  test('draws a warp that divides by 0', () => {
    for (const offset of [beat, drift])
      for (const millis of [0, 1200]) {
        const view = sceneWith(offset, { uniforms: { period: 0 } })
        view.babylonWarp.millis = millis
        view.babylonWarp.refresh(view.mesh)
        assert.equal(isDrawn(view), true)
        view.scene.pick(0, 0)
        view.scene.dispose()
      }
  })

  test('a vertex without a finite position neither throws nor hides the others', () => {
    for (const value of [NaN, Infinity]) {
      const view = sceneWith(({ glsl }) => glsl.vec3(0, 0.5, 0), {})
      const positions = view.mesh.getVerticesData('position')
      positions[0] = value
      view.mesh.setVerticesData('position', positions, true)
      view.babylonWarp.refresh(view.mesh)
      assert.equal(isDrawn(view), true)
      const { minimum, maximum } = view.mesh.getBoundingInfo().boundingBox
      for (const corner of [minimum, maximum])
        assert.ok([corner.x, corner.y, corner.z].every(Number.isFinite))
      view.scene.dispose()
    }
  })
})
