// Tests the parts of 'warpjet/three' that need no rendering: rays, bounds, uniforms, error messages, and that dispose() restores
// everything.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { MeshBVH, acceleratedRaycast, computeBatchedBoundsTree } from 'three-mesh-bvh'
import { WarpError, compileWarp } from 'warpjet'
import { bend, bulge, shear, spherify, stretch, taper, twist } from 'warpjet/deformers'
import { glslOffset } from 'warpjet/glsl'
import { bakeWarp } from 'warpjet/mesh'
import {
  addSurfaceVariation,
  fromBufferGeometry,
  toBufferGeometry,
  warp,
  warpMaterial,
} from 'warpjet/three'
import { isRun } from '../../.scripts/lib/tiers.mjs'

const wave = ({ glsl, position, uniforms, millis }) =>
  glsl.vec3(0, 0, position.x().mult(3).add(millis.div(500)).sin().mult(uniforms.height))

const plane = (more = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })) =>
  new THREE.Mesh(new THREE.PlaneGeometry(2, 2, 40, 40), more)

/** Makes a generator of numbers from 0 to 1, the same in each run. */
function randomNumbers(seed = 1) {
  let state = seed
  return () => (state = (state * 16807) % 2147483647) / 2147483647
}

const rayFrom = (random, target, spread) => {
  const from = new THREE.Vector3(random() - 0.5, random() - 0.5, random() - 0.5)
    .normalize()
    .multiplyScalar(8)
  const to = new THREE.Vector3(random() - 0.5, random() - 0.5, random() - 0.5)
    .multiplyScalar(spread)
    .add(target)
  return new THREE.Raycaster(from, to.sub(from).normalize())
}

/** Makes a plain mesh whose vertices have the expected warped positions, computed in double precision. */
function makeReference(mesh, place, instance = new THREE.Matrix4()) {
  const geometry = mesh.geometry.toNonIndexed()
  const { position } = geometry.attributes
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)]
    position.setXYZ(i, ...place(x, y, z))
  }
  geometry.computeBoundingSphere()
  const made = new THREE.Mesh(geometry, mesh.material)
  made.matrixWorld.multiplyMatrices(mesh.matrixWorld, instance)
  return made
}

function transform(mesh) {
  mesh.position.set(0.3, -0.2, 0.1)
  mesh.rotation.set(0.4, 0.8, -0.3)
  mesh.scale.set(1.2, 0.8, 1)
  mesh.updateMatrixWorld(true)
  return mesh
}

/** Asserts that rays hit a mesh at the same points as the other objects, or hit neither. */
function assertSameHits(mesh, others, { rays = 200, spread = 1.5, random = randomNumbers() } = {}) {
  let hits = 0
  for (let i = 0; i < rays; i++) {
    const ray = rayFrom(random, new THREE.Vector3(0.3, -0.2, 0.1), spread)
    const found = ray.intersectObject(mesh)
    const expected = others.flatMap((other) => ray.intersectObject(other, false))
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
  const at = (millis) => (x, y, z) => [x, y, z + height * Math.sin(3 * x + millis / 500)]

  test('of a mesh, also after uniforms change', () => {
    const mesh = transform(plane())
    const warped = warp(mesh, wave, { uniforms: { height } })
    // The last time is after a week.
    for (const millis of [0, 700, 6e8 + 700]) {
      warped.update(millis)
      assertSameHits(mesh, [makeReference(mesh, at(millis))])
    }
    warped.uniforms.height.value = 0
    assertSameHits(mesh, [makeReference(mesh, (...place) => place)])
    warped.dispose()
    assertSameHits(mesh, [makeReference(mesh, (...place) => place)])
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
      matrices.map((matrix) => makeReference(mesh, at(0), matrix)),
    )
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0, 9), new THREE.Vector3(0, 0, -1))
    for (const hit of ray.intersectObject(mesh)) assert.ok(hit.instanceId in matrices)
    warped.dispose()
  })

  test('in world space, of a mesh and of instances', () => {
    const offset = ({ glsl, position }) => glsl.vec3(0, position.x().mult(3).sin().mult(0.3), 0)
    const inWorld = (mesh, instance = new THREE.Matrix4()) => {
      const all = new THREE.Matrix4().multiplyMatrices(mesh.matrixWorld, instance)
      const made = makeReference(mesh, (x, y, z) => {
        const place = new THREE.Vector3(x, y, z).applyMatrix4(all)
        return [place.x, place.y + 0.3 * Math.sin(3 * place.x), place.z]
      })
      made.matrixWorld.identity()
      return made
    }
    const mesh = transform(plane())
    warp(mesh, offset, { space: 'world' })
    assertSameHits(mesh, [inWorld(mesh)])
    const many = transform(new THREE.InstancedMesh(mesh.geometry, mesh.material, 2))
    const matrices = [
      new THREE.Matrix4().makeTranslation(1, 0, 0),
      new THREE.Matrix4().makeScale(0.5, 1, 1),
    ]
    matrices.forEach((matrix, i) => many.setMatrixAt(i, matrix))
    many.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
    warp(many, offset, { space: 'world' })
    assertSameHits(
      many,
      matrices.map((matrix) => inWorld(many, matrix)),
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

  test('never of a warp that only the GPU can evaluate, which causes one warning', (t) => {
    const said = t.mock.method(console, 'warn', () => {})
    const mesh = plane()
    const map = new THREE.DataTexture(new Uint8Array(4), 1, 1)
    const warped = warp(mesh, ({ glsl, uniforms, uv }) => glsl.texture(uniforms.map, uv).xyz(), {
      uniforms: { map },
      surfaceVariation: false,
    })
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0, 9), new THREE.Vector3(0, 0, -1))
    assert.equal(ray.intersectObject(mesh).length + ray.intersectObject(mesh).length, 0)
    assert.equal(said.mock.callCount(), 1)
    assert.match(said.mock.calls[0].arguments[0], /^warp: rays miss a warp that/)
    assert.equal(mesh.boundingSphere.radius, Infinity)
    warped.dispose()
  })
})

function makeSkinnedMesh() {
  const geometry = new THREE.CylinderGeometry(0.2, 0.2, 2, 8, 10)
  const { position } = geometry.attributes
  const weights = []
  for (let i = 0; i < position.count; i++) {
    const amount = (position.getY(i) + 1) / 2
    weights.push(1 - amount, amount, 0, 0)
  }
  geometry.setAttribute(
    'skinIndex',
    new THREE.Uint16BufferAttribute(
      weights.map((_, i) => [0, 1, 0, 0][i % 4]),
      4,
    ),
  )
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4))
  const bones = [new THREE.Bone(), new THREE.Bone()]
  bones[0].add(bones[1])
  const mesh = new THREE.SkinnedMesh(
    geometry,
    new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }),
  )
  mesh.add(bones[0])
  mesh.bind(new THREE.Skeleton(bones))
  return mesh
}

function makeMorphingMesh() {
  const mesh = plane()
  const to = mesh.geometry.attributes.position.clone()
  for (let i = 0; i < to.count; i++) to.setXYZ(i, 2 * to.getX(i), to.getY(i), 1)
  mesh.geometry.morphAttributes.position = [to]
  mesh.updateMorphTargets()
  return mesh
}

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
        const instances = placesOf(mesh, space, warped)
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
          const seen = instances.map((places) => places.some((at) => frustum.containsPoint(at)))
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

/** Makes a batch of a ball and a ring, each at two positions. */
function makeBatch() {
  const geometries = [
    new THREE.SphereGeometry(1.2, 24, 16),
    new THREE.TorusGeometry(1, 0.4, 12, 32),
  ]
  const [vertices, indices] = ['position', 'index'].map((name) =>
    geometries.reduce((sum, each) => sum + (each[name] ?? each.attributes[name]).count, 0),
  )
  const mesh = new THREE.BatchedMesh(4, vertices, indices, new THREE.MeshBasicMaterial())
  const ids = geometries.map((each) => mesh.addGeometry(each))
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
function placesOf(mesh, space, { uniforms }) {
  const height = uniforms.height.value
  const { millis } = mesh.userData
  const lift = (place) => {
    place.z += height * Math.sin(3 * place.x + millis / 500)
    return place
  }
  const isMany = mesh.isInstancedMesh || mesh.isBatchedMesh
  const posed = space === 'rest' ? withLifted(mesh, lift) : mesh
  return Array.from({ length: isMany ? (mesh.instanceCount ?? mesh.count) : 1 }, (_, instance) => {
    const matrix = new THREE.Matrix4()
    if (isMany) mesh.getMatrixAt(instance, matrix)
    const { vertexStart = 0, vertexCount = mesh.geometry.attributes.position.count } =
      mesh.isBatchedMesh ? mesh.getGeometryRangeAt(mesh.getGeometryIdAt(instance)) : {}
    return Array.from({ length: vertexCount }, (_, i) => {
      const place = posed.getVertexPosition(vertexStart + i, new THREE.Vector3())
      if (space === 'local') lift(place)
      place.applyMatrix4(matrix).applyMatrix4(mesh.matrixWorld)
      return space === 'world' ? lift(place) : place
    })
  })
}

/** Returns a view of the mesh whose geometry is lifted, before morph targets and bones apply. */
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

test('uniforms have the form of those of three.js, and reject invalid values with a message', () => {
  const { uniforms, dispose } = warp(
    plane(),
    ({ uniforms }) =>
      uniforms.tint
        .mult(uniforms.place.x())
        .add(uniforms.turn.mult(uniforms.shift))
        .mult(uniforms.follow),
    {
      uniforms: {
        tint: new THREE.Color(1, 0, 0),
        place: new THREE.Vector2(1, 2),
        turn: new THREE.Matrix3(),
        shift: [1, 2, 3],
        follow: () => 2,
      },
    },
  )
  uniforms.shift.value = new THREE.Vector3(4, 5, 6)
  uniforms.shift.value.x = 7
  uniforms.follow.value = 3
  assert.throws(() => (uniforms.shift.value = 3), {
    name: 'WarpError',
    message: `warp: expected an array of 3 finite numbers for the uniform "shift", got the number 3.`,
  })
  assert.throws(() => (uniforms.follow.value = NaN), WarpError)
  assert.equal(uniforms.follow.value, 3)
  assert.throws(() => uniforms.heigth.value, {
    message: 'warp: the warp has no uniform "heigth"; there are tint, place, turn, shift, follow.',
  })
  dispose()
})

describe('warp throws a message, and changes nothing, for', () => {
  const none = ({ position }) => position
  const mesh = plane()
  const { material } = mesh
  const group = new THREE.Group().add(new THREE.Sprite())
  const bare = new THREE.BufferGeometry().setAttribute(
    'position',
    mesh.geometry.getAttribute('position'),
  )
  const cases = {
    'a sprite': [
      () => warp(new THREE.Sprite(), none),
      /^warp: this Sprite always faces the camera/,
    ],
    'a group of sprites': [() => warp(group, none), /^warp: this Sprite /],
    nothing: [() => warp(undefined, none), /^warp: expected a Mesh, .* got undefined\.$/],
    'an empty group': [
      () => warp(new THREE.Group(), none),
      /^warp: there is nothing to draw in this Group/,
    ],
    'a value that is not an offset function': [
      () => warp(mesh, 5),
      /^warp: expected a function, got the number 5/,
    ],
    'an offset function that returns a number': [
      () => warp(mesh, () => 5),
      /^warp: the offset function must return a vec3/,
    ],
    'an unknown space': [
      () => warp(mesh, none, { space: 'view' }),
      /^warp: expected 'local', 'rest' or 'world' for the option "space", got the text "view"\.$/,
    ],
    'a geometry': [() => warp(mesh.geometry, none), /got a PlaneGeometry\.$/],
    'an offset along a missing normal': [
      () => warp(new THREE.Mesh(bare, material), ({ normal }) => normal),
      /^warp: the offset reads normal, but the geometry of this Mesh has no attribute "normal"; call geometry\.computeVertexNormals\(\) first\.$/,
    ],
    'an offset that reads missing texture coordinates': [
      () => warp(new THREE.Points(bare), ({ glsl, uv }) => glsl.vec3(uv, 0)),
      /^warp: the offset reads uv, but the geometry of this Points has no attribute "uv"/,
    ],
    'an offset that reads the number of an instance': [
      () => warp(mesh, ({ glsl, instance }) => glsl.vec3(instance, 0, 0)),
      /^warp: the offset reads instance, which three\.js does not have; place instances by their matrices/,
    ],
    'an unknown option': [
      () => warp(mesh, none, { colour: 1 }),
      /^warp: there is no option "colour"/,
    ],
    'an offset that reads the mouse': [
      () => warp(mesh, ({ glsl, mouse }) => glsl.vec3(mouse, 0)),
      /^warp: the offset reads mouse, which three\.js does not have/,
    ],
    'an offset with an undeclared parameter': [
      () => warp(mesh, ({ glsl }) => glsl.vec3(glsl.param('wind'), 0, 0)),
      /^warp: the offset reads "wind" by glsl\.param/,
    ],
    'a shader that does not read positions': [
      () =>
        warpMaterial(
          new THREE.ShaderMaterial({ vertexShader: 'void main() { gl_Position = vec4( 1.0 ); }' }),
          none,
        ),
      /^warpMaterial: the ShaderMaterial cannot be warped: its vertex shader neither reads the attribute position/,
    ],
    'a material of WebGPURenderer': [
      () =>
        warpMaterial(
          Object.assign(new THREE.Material(), { isNodeMaterial: true, type: 'MeshNode' }),
          none,
        ),
      /the MeshNode cannot be warped: only WebGPURenderer draws it; import 'warpjet\/three\/webgpu'\.$/,
    ],
    'a mesh instead of a material': [
      () => warpMaterial(mesh, none),
      /^warpMaterial: expected a material of three\.js, got a Mesh\.$/,
    ],
  }
  for (const [name, [work, message]] of Object.entries(cases))
    test(name, () => {
      assert.throws(work, (error) => {
        assert.equal(error.name, 'WarpError')
        assert.match(error.message, message)
        return true
      })
      assert.equal(mesh.material, material)
      assert.equal(Object.hasOwn(mesh, 'raycast'), false)
    })

  test('an unsupported object alone; in a group, it warns once and warps the others', async (t) => {
    const said = t.mock.method(console, 'warn', () => {})
    const { LineMaterial } = await import('three/addons/lines/LineMaterial.js')
    const { LineSegments2 } = await import('three/addons/lines/LineSegments2.js')
    const { LineSegmentsGeometry } = await import('three/addons/lines/LineSegmentsGeometry.js')
    const wide = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial())
    wide.name = 'route'
    const sprite = new THREE.Sprite()
    const part = plane()
    const parts = new THREE.Group().add(part, sprite, wide)
    const warped = warp(parts, ({ glsl }) => glsl.vec3(0, 0, 2))
    assert.deepEqual(warped.skipped, [sprite, wide])
    assert.ok(warped.bounds().max.z > 1.9)
    assert.equal(said.mock.callCount(), 1)
    const [message] = said.mock.calls[0].arguments
    assert.match(message, /^warp: drawn without the warp: this Sprite always faces the camera/)
    assert.match(
      message,
      /; the LineMaterial of the LineSegments2 "route" cannot be warped: .* use a Line/,
    )
    warped.dispose()
    assert.throws(
      () => warp(wide, none),
      /^WarpError: warp: the LineMaterial of the LineSegments2 "route"/,
    )
  })

  test('a mesh that is already warped', () => {
    const warped = warp(mesh, none)
    assert.throws(() => warp(mesh, none), /^WarpError: warp: this Mesh is warped already/)
    warped.dispose()
    warp(mesh, none).dispose()
  })
})

describe('a second warp of the same object throws', () => {
  const none = ({ position }) => position
  const cases = {
    'on a clone of a warped mesh, which is warped, too'(mesh) {
      warp(mesh, none)
      return [
        [() => warp(mesh.clone(), none), /this Mesh is warped already, or a clone of a warped/],
        [() => warp(new THREE.Group().add(mesh.clone()), none), /is warped already/],
      ]
    },
    'after warpMaterial'(mesh) {
      const { material } = warpMaterial(mesh.material, none)
      mesh.material = material
      const message =
        /the MeshBasicMaterial( of this Mesh)? cannot be warped: a call of warpMaterial/
      return [
        [() => warp(mesh, none), message],
        [() => warpMaterial(material, none), message],
      ]
    },
    'after warpMaterial with the option share'(mesh) {
      warpMaterial(mesh.material, none, { share: true })
      return [[() => warp(mesh, none), /a call of warpMaterial/]]
    },
  }
  for (const [name, make] of Object.entries(cases))
    test(name, () => {
      for (const [again, message] of make(plane()))
        assert.throws(again, (error) => {
          assert.equal(error.name, 'WarpError')
          assert.match(error.message, message)
          return true
        })
    })

  test('unless the first one was disposed of', () => {
    const mesh = plane()
    warp(mesh, none, { share: true }).dispose()
    warp(mesh, none, { share: true }).dispose()
    const warped = warp(mesh, none)
    const clone = mesh.clone()
    warped.dispose()
    warp(clone, none)
  })

  test('unless the objects only share their material', () => {
    const mesh = plane()
    warp(mesh, none)
    warp(new THREE.Mesh(mesh.geometry, mesh.material), none)
  })
})

describe('in world space rays hit a warp along the normal, with the same normals as for a geometry in world coordinates:', () => {
  const offsets = {
    'along the normal': ({ glsl, normal, position }) =>
      normal.mult(position.x().mult(3).sin().mult(0.2)).add(glsl.vec3(0, 0, 0.1)),
    'by uv': ({ normal, uv }) => normal.mult(uv.x().mult(20).sin().mult(0.1)),
  }
  const turned = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(0.7, -1.1, 0.4))
  const stretched = turned
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
      const matrix = turned
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
    // The ellipsoid is q · S q = 1 with S = B^T B; its normal is S q / |S q|.
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

/** Adds the gradients of the normal of the surface q · S q = 1, derived by hand. */
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

test('dispose() restores everything, and a second call does nothing', () => {
  for (const mesh of [plane(), makeSkinnedMesh(), new THREE.Points(plane().geometry)])
    for (const share of [false, true]) {
      // Three.js keeps an empty list of listeners.
      const own = (object) =>
        Object.entries(Object.getOwnPropertyDescriptors(object)).filter(
          ([name]) => name !== '_listeners',
        )
      const [before, materialBefore] = [own(mesh), own(mesh.material)]
      const { material } = mesh
      const warped = warp(mesh, wave, { uniforms: { height: 1 }, share })
      assert.notDeepEqual(own(mesh), before)
      assert.equal(mesh.material, material)
      assert.deepEqual(own(material), materialBefore)
      warped.dispose()
      warped.dispose()
      assert.deepEqual(own(mesh), before)
      assert.deepEqual(own(material), materialBefore)
    }
})

describe('a renderer draws', () => {
  const none = ({ position }) => position
  const mockRenderer = () => {
    const drawn = []
    const renderer = {
      drawn,
      renderBufferDirect: (...given) => drawn.push(given[3]),
      compile() {},
      properties: { get: () => ({}) },
    }
    return renderer
  }
  const draw = (renderer, object, material = object.material) =>
    renderer.renderBufferDirect(null, null, object.geometry, material, object, null)

  test('a warped object with a live view of its current material, and other objects unchanged', () => {
    const mesh = plane()
    const warped = warp(mesh, none)
    const renderer = mockRenderer()
    mesh.onBeforeShadow(renderer)
    mesh.onBeforeRender(renderer)
    const override = new THREE.MeshNormalMaterial()
    draw(renderer, mesh)
    draw(renderer, mesh, override)
    draw(renderer, mesh)
    const other = plane()
    draw(renderer, other)
    const [first, second, again, unwarped] = renderer.drawn
    assert.notEqual(first, mesh.material)
    assert.ok(first instanceof THREE.Material)
    assert.equal(first, again)
    assert.equal(second.type, 'MeshNormalMaterial')
    assert.equal(unwarped, other.material)
    mesh.material.color.set('red')
    mesh.material.mine = 1
    assert.equal(first.color.getHex(), 0xff0000)
    assert.equal(first.mine, 1)
    first.side = THREE.BackSide
    assert.equal(mesh.material.side, THREE.BackSide)
    assert.notEqual(first.id, mesh.material.id)
    warped.dispose()
    draw(renderer, mesh)
    assert.equal(renderer.drawn.at(-1), mesh.material)
  })

  test('a material that cannot be warped unchanged, and logs one error', (t) => {
    const said = t.mock.method(console, 'error', () => {})
    const mesh = plane()
    mesh.name = 'flag'
    const warped = warp(mesh, none)
    const renderer = mockRenderer()
    mesh.onBeforeRender(renderer)
    mesh.material = new THREE.SpriteMaterial()
    draw(renderer, mesh)
    draw(renderer, mesh)
    assert.deepEqual(renderer.drawn, [mesh.material, mesh.material])
    assert.equal(said.mock.callCount(), 1)
    assert.match(
      said.mock.calls[0].arguments[0],
      /^warp: the SpriteMaterial of the Mesh "flag" is drawn without the warp: a sprite always/,
    )
    warped.dispose()
  })

  test('an unwarped object with at most 0.2 microseconds of overhead', (t) => {
    const mesh = plane()
    const warped = warp(mesh, none)
    const renderer = { renderBufferDirect() {}, compile() {} }
    const times = (object) => {
      const start = performance.now()
      for (let i = 0; i < 200_000; i++) draw(renderer, object)
      return performance.now() - start
    }
    const other = plane()
    const plainTime = Math.min(...Array.from({ length: 5 }, () => times(other)))
    mesh.onBeforeRender(renderer)
    const wrappedTime = Math.min(...Array.from({ length: 5 }, () => times(other)))
    const overhead = (1000 * (wrappedTime - plainTime)) / 200_000
    t.diagnostic(
      `${overhead.toFixed(3)} microseconds more than ${((1000 * plainTime) / 200_000).toFixed(3)}`,
    )
    assert.ok(overhead < 0.2)
    warped.dispose()
  })
})

test('a callback assigned while an object is warped is preserved, and may call the previous one', () => {
  const mesh = plane()
  const calls = []
  mesh.onBeforeRender = () => calls.push('first')
  const warped = warp(mesh, ({ position }) => position)
  const renderer = () => ({ renderBufferDirect() {}, compile() {} })
  const { onBeforeRender } = mesh
  const second = (mesh.onBeforeRender = (...given) => {
    calls.push('second')
    onBeforeRender.call(mesh, ...given)
  })
  mesh.onBeforeRender(renderer())
  assert.deepEqual(calls, ['second', 'first'])
  warped.dispose()
  assert.equal(mesh.onBeforeRender, second)
  const material = new THREE.MeshBasicMaterial()
  const again = warp(mesh, ({ position }) => position)
  mesh.material = material
  again.dispose()
  assert.equal(mesh.material, material)
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

test('toBufferGeometry restores what a baked mesh cannot hold, such as groups and further attributes', () => {
  const { geometry } = plane()
  geometry.setAttribute('uv1', geometry.attributes.uv.clone())
  geometry.setAttribute(
    'color',
    new THREE.Uint8BufferAttribute(
      new Uint8Array(3 * geometry.attributes.position.count).fill(255),
      3,
      true,
    ),
  )
  geometry.addGroup(0, 30, 1)
  const baked = bakeWarp(
    fromBufferGeometry(geometry),
    compileWarp(({ glsl }) => glsl.vec3(0, 0, 1)),
  )
  const made = toBufferGeometry(baked, geometry)
  assert.equal(made.attributes.position.getZ(5), 1)
  assert.equal(made.index.count, geometry.index.count)
  assert.deepEqual([...made.attributes.uv1.array], [...geometry.attributes.uv1.array])
  assert.deepEqual(made.attributes.color.array.slice(0, 4), new Float32Array([1, 1, 1, 1]))
  assert.deepEqual(made.groups, geometry.groups)
  assert.throws(() => toBufferGeometry(baked, new THREE.BoxGeometry()), WarpError)
  assert.throws(() => fromBufferGeometry(new THREE.BufferGeometry()), WarpError)
  assert.throws(() => fromBufferGeometry(3), WarpError)
})

test('addSurfaceVariation adds the gradients of the normals to a geometry', async () => {
  const geometry = await addSurfaceVariation(new THREE.SphereGeometry(2, 40, 30))
  const { position, aWarpjet_normalXGradient: gradient } = geometry.attributes
  // The normal of a sphere is position / radius: its gradients are the axes, projected, over the radius.
  for (const i of [300, 500, 700]) {
    const normal = new THREE.Vector3().fromBufferAttribute(position, i).normalize()
    const expected = new THREE.Vector3(1, 0, 0).addScaledVector(normal, -normal.x).divideScalar(2)
    assert.ok(new THREE.Vector3().fromBufferAttribute(gradient, i).distanceTo(expected) < 0.02)
  }
  await assert.rejects(addSurfaceVariation(5), WarpError)
})

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

/** The number of rays for each of the ten warps. */
const rays = isRun('a thousand rays') ? 1000 : 100

test('a thousand rays hit ten warps where they hit the baked meshes', () => {
  const { min, max } = Math
  const geometry = new THREE.TorusKnotGeometry(0.7, 0.25, 64, 12)
  const random = randomNumbers(3)
  for (const [i, offset] of tenWarps.entries()) {
    const mesh = transform(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial()))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const compiled = compileWarp(offset, { surfaceVariation: false })
    const other = new THREE.Mesh(bakeWarp(geometry, compiled), mesh.material)
    other.matrixWorld.copy(mesh.matrixWorld)
    const { array } = other.geometry.attributes.position
    assert.ok(max(...array) - min(...array) < 20, `warp ${i}`)
    assertSameHits(mesh, [other], { rays, random })
    warped.dispose()
  }
})

test('a thousand rays hit ten warps within 1e-4 of the size of the mesh from the hits of a denser baked mesh', (t) => {
  const random = randomNumbers(5)
  const both = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
  const patch = (along, down) => new THREE.SphereGeometry(1, along, down, 0, 2, 0.5, 1.4)
  const [fine, finer] = [patch(170, 120), patch(340, 240)]
  const spread = () => new THREE.Vector3(random(), random(), random()).subScalar(0.5)
  let worst = 0
  for (const offset of tenWarps) {
    const mesh = transform(new THREE.Mesh(fine, both))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const baked = bakeWarp(finer, compileWarp(offset, { surfaceVariation: false }))
    baked.boundsTree = new MeshBVH(baked)
    const dense = new THREE.Mesh(baked, both)
    dense.raycast = acceleratedRaycast
    dense.matrixWorld.copy(mesh.matrixWorld)
    const size = warped.bounds().getSize(new THREE.Vector3()).length()
    const { position, normal } = baked.attributes
    for (let i = 0; i < rays / 10; i++) {
      // From somewhere above the surface to a point away from the edge.
      const [u, v] = [0.1 + 0.8 * random(), 0.1 + 0.8 * random()]
      const vertex = Math.round(340 * u) + 341 * Math.round(240 * v)
      const to = new THREE.Vector3()
        .fromBufferAttribute(position, vertex)
        .add(spread().multiplyScalar(1e-3))
      const from = new THREE.Vector3()
        .fromBufferAttribute(normal, vertex)
        .add(spread())
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
  const partly = warp(mesh, up)
  const down = new THREE.Raycaster(new THREE.Vector3(), new THREE.Vector3(0, 0, -1))
  const hits = () => {
    let count = 0
    for (const x of [-0.9, 0.9])
      for (const y of [-0.9, 0.9]) {
        down.ray.origin.set(x, y, 9)
        count += down.intersectObject(mesh).length
      }
    return count
  }
  const before = hits()
  mesh.geometry.setDrawRange(0, index.count)
  assert.ok(hits() > before, `${before} hits of four before, ${hits()} after`)
  partly.dispose()
})

test("messages explain the difference from three.js's own notation of uniforms", () => {
  const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.a, 0, 0)
  const expectError = (work, message) => assert.throws(work, { name: 'WarpError', message })
  expectError(
    () => warp(plane(), offset, { uniforms: { a: { value: 1 } } }),
    /; pass its value itself\.$/,
  )
  const warped = warp(plane(), offset, { uniforms: { a: 1 } })
  expectError(() => (warped.uniforms.a = 2), /set its value, as in uniforms\.a\.value = 0\.5/)
  warped.dispose()
})

test('GLSL source can be an offset, too', () => {
  const mesh = plane()
  const warped = warp(
    mesh,
    glslOffset('vec3 offset(vec3 p) { return vec3(0.0, 0.0, 2.0 + sin(p.x)); }'),
  )
  const ray = new THREE.Raycaster(new THREE.Vector3(0, 0.2, 9), new THREE.Vector3(0, 0, -1))
  const [hit] = ray.intersectObject(mesh)
  assert.ok(Math.abs(hit.point.z - 2) < 1e-4)
  warped.dispose()
})
