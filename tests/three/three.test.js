// 'warpjet/three' where no pixel is needed: rays, bounds, uniforms, what is refused, and that dispose() leaves nothing.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compileWarp, WarpError } from 'warpjet'
import {
  fromBufferGeometry,
  toBufferGeometry,
  warp,
  warpMaterial,
  addSurfaceVariation,
} from 'warpjet/three'
import { glslOffset } from 'warpjet/glsl'
import { bakeWarp } from 'warpjet/mesh'
import { MeshBVH, acceleratedRaycast, computeBatchedBoundsTree } from 'three-mesh-bvh'
import { bend, bulge, shear, spherify, stretch, taper, twist } from 'warpjet/deformers'

const wave = ({ glsl, position, uniforms, millis }) =>
  glsl.vec3(0, 0, position.x().mult(3).add(millis.div(500)).sin().mult(uniforms.height))

const plane = (more = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })) =>
  new THREE.Mesh(new THREE.PlaneGeometry(2, 2, 40, 40), more)

/** Numbers from 0 to 1, the same in each run. */
function numbers(seed = 1) {
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

/** Makes a plain mesh whose vertices are where the warp must put them, moved in double precision. */
function reference(mesh, place, instance = new THREE.Matrix4()) {
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

function placed(mesh) {
  mesh.position.set(0.3, -0.2, 0.1)
  mesh.rotation.set(0.4, 0.8, -0.3)
  mesh.scale.set(1.2, 0.8, 1)
  mesh.updateMatrixWorld(true)
  return mesh
}

/** Both rays hit at the same places, or neither does; how many did. */
function sameHits(mesh, others, { rays = 200, spread = 1.5, random = numbers() } = {}) {
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

describe('rays meet the warped surface', () => {
  const height = 0.3
  const at = (millis) => (x, y, z) => [x, y, z + height * Math.sin(3 * x + millis / 500)]

  test('of a mesh, also when the uniforms change', () => {
    const mesh = placed(plane())
    const warped = warp(mesh, wave, { uniforms: { height } })
    // The last one after a week.
    for (const millis of [0, 700, 6e8 + 700]) {
      warped.update(millis)
      sameHits(mesh, [reference(mesh, at(millis))])
    }
    warped.uniforms.height.value = 0
    sameHits(mesh, [reference(mesh, (...place) => place)])
    warped.dispose()
    sameHits(mesh, [reference(mesh, (...place) => place)])
  })

  test('of instances, with their number', () => {
    const { geometry, material } = plane()
    const mesh = placed(new THREE.InstancedMesh(geometry, material, 3))
    const matrices = [0, 1, 2].map((i) =>
      new THREE.Matrix4().compose(
        new THREE.Vector3(i - 1, 0.3 * i, 0),
        new THREE.Quaternion().setFromEuler(new THREE.Euler(i, 0.5, 0)),
        new THREE.Vector3(0.5, 0.4 + 0.2 * i, 0.6),
      ),
    )
    matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
    const warped = warp(mesh, wave, { uniforms: { height } })
    sameHits(
      mesh,
      matrices.map((matrix) => reference(mesh, at(0), matrix)),
    )
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0, 9), new THREE.Vector3(0, 0, -1))
    for (const hit of ray.intersectObject(mesh)) assert.ok(hit.instanceId in matrices)
    warped.dispose()
  })

  test('in the world, of a mesh and of instances', () => {
    const offset = ({ glsl, position }) => glsl.vec3(0, position.x().mult(3).sin().mult(0.3), 0)
    const inWorld = (mesh, instance = new THREE.Matrix4()) => {
      const all = new THREE.Matrix4().multiplyMatrices(mesh.matrixWorld, instance)
      const made = reference(mesh, (x, y, z) => {
        const place = new THREE.Vector3(x, y, z).applyMatrix4(all)
        return [place.x, place.y + 0.3 * Math.sin(3 * place.x), place.z]
      })
      made.matrixWorld.identity()
      return made
    }
    const mesh = placed(plane())
    warp(mesh, offset, { space: 'world' })
    sameHits(mesh, [inWorld(mesh)])
    const many = placed(new THREE.InstancedMesh(mesh.geometry, mesh.material, 2))
    const matrices = [
      new THREE.Matrix4().makeTranslation(1, 0, 0),
      new THREE.Matrix4().makeScale(0.5, 1, 1),
    ]
    matrices.forEach((matrix, i) => many.setMatrixAt(i, matrix))
    many.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
    warp(many, offset, { space: 'world' })
    sameHits(
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

  test('by three-mesh-bvh, assigned before the warp and after it, also of a batch', () => {
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

  test('of one that only the GPU can run they miss, and say so once', (t) => {
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

function skinned() {
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

function morphing() {
  const mesh = plane()
  const to = mesh.geometry.attributes.position.clone()
  for (let i = 0; i < to.count; i++) to.setXYZ(i, 2 * to.getX(i), to.getY(i), 1)
  mesh.geometry.morphAttributes.position = [to]
  mesh.updateMorphTargets()
  return mesh
}

test('nothing that is visible is culled, in ten thousand settings, and little else is drawn', (t) => {
  const random = numbers(7)
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
    batched,
    skinned,
    morphing,
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
          const those = isDrawn ? drawnOf(mesh, camera) : []
          seen.forEach((is, i) => assert.ok(!is || those.includes(i), `${space}: ${i} culled`))
          drawnInBatch += those.length
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

/** A batch of a ball and a ring, each at two places. */
function batched() {
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
function drawnOf(mesh, camera) {
  mesh.onBeforeRender({}, undefined, camera, mesh.geometry, mesh.material)
  return [...mesh._indirectTexture.image.data.slice(0, mesh._multiDrawCount)]
}

/** The vertices of each instance in the world, each computed by itself in double. */
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

/** The mesh, the vertices of its geometry moved before anything else is. */
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

test('uniforms are those of three.js, and say what is wrong with them', () => {
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

describe('what cannot be warped is refused by a sentence, and nothing is changed', () => {
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
    'an offset that is none': [() => warp(mesh, 5), /^warp: expected a function, got the number 5/],
    'an offset that gives a number': [
      () => warp(mesh, () => 5),
      /^warp: the offset function must return a vec3/,
    ],
    'a space that is none': [
      () => warp(mesh, none, { space: 'view' }),
      /^warp: expected 'local', 'rest' or 'world' for the option "space", got the text "view"\.$/,
    ],
    'a geometry': [() => warp(mesh.geometry, none), /got a PlaneGeometry\.$/],
    'along a normal that is missing': [
      () => warp(new THREE.Mesh(bare, material), ({ normal }) => normal),
      /^warp: the offset reads normal, but the geometry of this Mesh has no attribute "normal"; call geometry\.computeVertexNormals\(\) first\.$/,
    ],
    'by texture coordinates that are missing': [
      () => warp(new THREE.Points(bare), ({ glsl, uv }) => glsl.vec3(uv, 0)),
      /^warp: the offset reads uv, but the geometry of this Points has no attribute "uv"/,
    ],
    'instances by number': [
      () => warp(mesh, ({ glsl, instance }) => glsl.vec3(instance, 0, 0)),
      /^warp: the offset reads instance, which three\.js does not have; place instances by their matrices/,
    ],
    'an option that is none': [
      () => warp(mesh, none, { colour: 1 }),
      /^warp: there is no option "colour"/,
    ],
    'the mouse': [
      () => warp(mesh, ({ glsl, mouse }) => glsl.vec3(mouse, 0)),
      /^warp: the offset reads mouse, which three\.js does not have/,
    ],
    'a parameter': [
      () => warp(mesh, ({ glsl }) => glsl.vec3(glsl.param('wind'), 0, 0)),
      /^warp: the offset reads "wind" by glsl\.param/,
    ],
    'a shader that makes its vertices from nothing': [
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
    'no material': [
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

  test('in a group, which warps the others and names it once', async (t) => {
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

  test('a mesh that is warped already', () => {
    const warped = warp(mesh, none)
    assert.throws(() => warp(mesh, none), /^WarpError: warp: this Mesh is warped already/)
    warped.dispose()
    warp(mesh, none).dispose()
  })
})

describe('two warps of one object are refused, since they would be drawn as one', () => {
  const none = ({ position }) => position
  const cases = {
    'on a clone of a warped mesh, which is warped itself'(mesh) {
      warp(mesh, none)
      return [
        [() => warp(mesh.clone(), none), /this Mesh is warped already, or a clone of a warped/],
        [() => warp(new THREE.Group().add(mesh.clone()), none), /is warped already/],
      ]
    },
    'by warpMaterial'(mesh) {
      const { material } = warpMaterial(mesh.material, none)
      mesh.material = material
      const refusal =
        /the MeshBasicMaterial( of this Mesh)? cannot be warped: a call of warpMaterial/
      return [
        [() => warp(mesh, none), refusal],
        [() => warpMaterial(material, none), refusal],
      ]
    },
    'by warpMaterial, in the material itself'(mesh) {
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

  test('and warped again when it no longer is', () => {
    const mesh = plane()
    warp(mesh, none, { share: true }).dispose()
    warp(mesh, none, { share: true }).dispose()
    const warped = warp(mesh, none)
    const clone = mesh.clone()
    warped.dispose()
    warp(clone, none)
  })

  test('but one material is drawn with as many warps as objects have it', () => {
    const mesh = plane()
    warp(mesh, none)
    warp(new THREE.Mesh(mesh.geometry, mesh.material), none)
  })
})

describe('rays meet normals in the world as those of a geometry that is there already', () => {
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

  function compare(placed, there, offset) {
    placed.updateMatrixWorld(true)
    warp(placed, offset, { space: 'world' })
    warp(there, offset)
    const toWorld = new THREE.Matrix3().getNormalMatrix(placed.matrixWorld)
    const random = numbers(7)
    let count = 0
    for (let i = 0; i < 60; i++) {
      const ray = rayFrom(random, placed.position, 1)
      const [[a], [b]] = [ray.intersectObject(placed), ray.intersectObject(there)]
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
    test(`${name}, turned and larger`, async () => {
      const matrix = turned
        .clone()
        .scale(new THREE.Vector3(2, 2, 2))
        .setPosition(1, 2, -1)
      const geometry = new THREE.TorusKnotGeometry(1, 0.4, 120, 24)
      const there = await addSurfaceVariation(geometry.clone().applyMatrix4(matrix))
      const placed = new THREE.Mesh(await addSurfaceVariation(geometry))
      placed.applyMatrix4(matrix)
      compare(placed, new THREE.Mesh(there), offset)
    })

  test('along the normal of an ellipsoid, of which all is known', () => {
    const geometry = new THREE.SphereGeometry(1, 80, 60)
    const there = geometry.clone().applyMatrix4(stretched)
    const back = new THREE.Matrix3().setFromMatrix4(stretched).invert()
    // The ellipsoid is q · S q = 1 with S = B^T B; its normal is S q / |S q|.
    const shape = back.clone().transpose().multiply(back)
    const center = new THREE.Vector3().setFromMatrixPosition(stretched)
    vary(geometry, new THREE.Matrix3(), new THREE.Vector3())
    vary(there, shape, center)
    const placed = new THREE.Mesh(geometry)
    placed.matrixAutoUpdate = false
    placed.matrix.copy(stretched)
    placed.position.copy(center)
    compare(placed, new THREE.Mesh(there), offsets['along the normal'])
  })
})

/** Says how the normals of q · S q = 1 vary along the surface, by hand. */
function vary(geometry, shape, center) {
  const { position } = geometry.attributes
  const gradients = [0, 1, 2].map(() => new Float32Array(3 * position.count))
  for (let i = 0; i < position.count; i++) {
    const q = new THREE.Vector3().fromBufferAttribute(position, i).sub(center)
    const normal = q.applyMatrix3(shape)
    const length = normal.length()
    normal.divideScalar(length)
    const along = (v) => v.addScaledVector(normal, -normal.dot(v))
    // The k-th row of (1 - n n^T) S (1 - n n^T) / |S q|.
    for (let k = 0; k < 3; k++) {
      const axis = along(new THREE.Vector3().setComponent(k, 1)).applyMatrix3(shape)
      along(axis)
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

test('dispose() leaves everything as it was, and a second one does nothing', () => {
  for (const mesh of [plane(), skinned(), new THREE.Points(plane().geometry)])
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
  const rendererOf = () => {
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

  test('a warped object with a live view of whichever material, and no other object', () => {
    const mesh = plane()
    const warped = warp(mesh, none)
    const renderer = rendererOf()
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

  test('a material that cannot be warped as it is, and says so once', (t) => {
    const said = t.mock.method(console, 'error', () => {})
    const mesh = plane()
    mesh.name = 'flag'
    const warped = warp(mesh, none)
    const renderer = rendererOf()
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

  test('an object that is not warped in less than 0.2 microseconds more', (t) => {
    const mesh = plane()
    const warped = warp(mesh, none)
    const renderer = { renderBufferDirect() {}, compile() {} }
    const times = (object) => {
      const start = performance.now()
      for (let i = 0; i < 200_000; i++) draw(renderer, object)
      return performance.now() - start
    }
    const other = plane()
    const bare = Math.min(...Array.from({ length: 5 }, () => times(other)))
    mesh.onBeforeRender(renderer)
    const wrapped = Math.min(...Array.from({ length: 5 }, () => times(other)))
    const more = (1000 * (wrapped - bare)) / 200_000
    t.diagnostic(
      `${more.toFixed(3)} microseconds more than ${((1000 * bare) / 200_000).toFixed(3)}`,
    )
    assert.ok(more < 0.2)
    warped.dispose()
  })
})

test('a method that is assigned while an object is warped stays, and may call the one before', () => {
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

test('bounds() is around what is drawn, of a group around all of it', () => {
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

test('a geometry becomes a mesh, is baked, and comes back with what only three.js knows', () => {
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

test('a geometry can say how its normals vary', async () => {
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

/** For each of the ten warps. */
const rays = isRun('a thousand rays') ? 1000 : 100

test('a thousand rays meet ten warps where they meet the baked meshes', () => {
  const { min, max } = Math
  const geometry = new THREE.TorusKnotGeometry(0.7, 0.25, 64, 12)
  const random = numbers(3)
  for (const [i, offset] of tenWarps.entries()) {
    const mesh = placed(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial()))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const compiled = compileWarp(offset, { surfaceVariation: false })
    const other = new THREE.Mesh(bakeWarp(geometry, compiled), mesh.material)
    other.matrixWorld.copy(mesh.matrixWorld)
    const { array } = other.geometry.attributes.position
    assert.ok(max(...array) - min(...array) < 20, `warp ${i}`)
    sameHits(mesh, [other], { rays, random })
    warped.dispose()
  }
})

test('a thousand rays meet ten warps within 1e-4 of the mesh of where a denser one of triangles has them', (t) => {
  const random = numbers(5)
  const both = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
  const patch = (along, down) => new THREE.SphereGeometry(1, along, down, 0, 2, 0.5, 1.4)
  const [fine, four] = [patch(170, 120), patch(340, 240)]
  const spread = () => new THREE.Vector3(random(), random(), random()).subScalar(0.5)
  let worst = 0
  for (const offset of tenWarps) {
    const mesh = placed(new THREE.Mesh(fine, both))
    const warped = warp(mesh, offset, { surfaceVariation: false })
    const baked = bakeWarp(four, compileWarp(offset, { surfaceVariation: false }))
    baked.boundsTree = new MeshBVH(baked)
    const dense = new THREE.Mesh(baked, both)
    dense.raycast = acceleratedRaycast
    dense.matrixWorld.copy(mesh.matrixWorld)
    const size = warped.bounds().getSize(new THREE.Vector3()).length()
    const { position, normal } = baked.attributes
    for (let i = 0; i < rays / 10; i++) {
      // To a place away from the edge, from somewhere above it.
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

test('an instance of a batch that is shown again, and more of a geometry, count for bounds and rays', () => {
  const batch = new THREE.BatchedMesh(2, 8, 12, new THREE.MeshStandardMaterial())
  const geometry = batch.addGeometry(new THREE.PlaneGeometry(1, 1))
  const [here, there] = [0, 5].map((x) => {
    const id = batch.addInstance(geometry)
    batch.setMatrixAt(id, new THREE.Matrix4().makeTranslation(x, 0, 0))
    return id
  })
  batch.setVisibleAt(there, false)
  const up = ({ glsl }) => glsl.vec3(0, 0, 2)
  const warped = warp(batch, up)
  const ray = new THREE.Raycaster(new THREE.Vector3(5, 0, 9), new THREE.Vector3(0, 0, -1))
  assert.ok(warped.bounds().max.x < 1)
  assert.equal(ray.intersectObject(batch).length, 0)
  batch.setVisibleAt(there, true)
  assert.ok(warped.bounds().max.x >= 5.5)
  assert.equal(ray.intersectObject(batch)[0].batchId, there)
  batch.setVisibleAt(here, false)
  assert.ok(warped.bounds().min.x > 4)
  warped.dispose()

  const mesh = plane()
  const { index } = mesh.geometry
  mesh.geometry.setDrawRange(0, 3)
  const partly = warp(mesh, up)
  const down = new THREE.Raycaster(new THREE.Vector3(), new THREE.Vector3(0, 0, -1))
  const hits = () => {
    let met = 0
    for (const x of [-0.9, 0.9])
      for (const y of [-0.9, 0.9]) {
        down.ray.origin.set(x, y, 9)
        met += down.intersectObject(mesh).length
      }
    return met
  }
  const before = hits()
  mesh.geometry.setDrawRange(0, index.count)
  assert.ok(hits() > before, `${before} hits of four before, ${hits()} after`)
  partly.dispose()
})

test('what three.js calls uniforms is told how it goes here', () => {
  const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.a, 0, 0)
  const refused = (work, message) => assert.throws(work, { name: 'WarpError', message })
  refused(
    () => warp(plane(), offset, { uniforms: { a: { value: 1 } } }),
    /; pass its value itself\.$/,
  )
  const warped = warp(plane(), offset, { uniforms: { a: 1 } })
  refused(() => (warped.uniforms.a = 2), /set its value, as in uniforms\.a\.value = 0\.5/)
  warped.dispose()
})

test('shader text is an offset too', () => {
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
