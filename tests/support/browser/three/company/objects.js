// Rows of the company tests for changes that users make to warped objects, and for clones of these.
import * as THREE from 'three'
import * as SkeletonUtils from 'three/addons/utils/SkeletonUtils.js'
import {
  camera,
  checker,
  litScene,
  makeRow,
  mesh,
  readPixels,
  renderer,
  size,
  standard,
  torus,
} from './lib.js'

const makeSmallMesh = (x = -0.7) => {
  const made = mesh()
  made.scale.setScalar(0.6)
  made.position.x = x
  return made
}

const makeGroup = (...parts) => {
  const group = new THREE.Group()
  group.add(...parts)
  return group
}

function makeInstances() {
  const made = new THREE.InstancedMesh(torus(), standard(), 1)
  made.setMatrixAt(0, new THREE.Matrix4().makeScale(0.6, 0.6, 0.6))
  made.position.x = -0.7
  return made
}

const addClone =
  (clone) =>
  ({ object, scene }) => {
    const made = clone(object)
    made.position.x += 1.4
    made.traverse((each) => (each.castShadow = each.receiveShadow = true))
    scene.add(made)
  }

const withShadow = (after) => ({ shadow: true, after })

/** Makes an InstancedMesh of one instance, whose morph target moves it far to the right of the geometry. */
function makeMorphingInstances(way) {
  const geometry = new THREE.SphereGeometry(0.4, 32, 24)
  const shift = geometry.attributes.position.clone()
  for (let i = 0; i < shift.count; i++) shift.setXYZ(i, 6, 0, 0)
  geometry.morphAttributes.position = [shift]
  geometry.morphTargetsRelative = true
  if (way === 'byHand') {
    const moved = new THREE.Mesh(geometry.clone().translate(6, 0, 0), standard())
    moved.geometry.morphAttributes = {}
    moved.frustumCulled = false
    moved.position.x = -6
    return moved
  }
  const made = new THREE.InstancedMesh(geometry, standard(), 1)
  made.setMatrixAt(0, new THREE.Matrix4())
  const source = new THREE.Mesh(geometry)
  source.morphTargetInfluences = [1]
  made.setMorphAt(0, source)
  made.morphTexture.needsUpdate = true
  made.position.x = -6
  return made
}

export const rows = {
  'a new material is assigned after a frame': makeRow(() => mesh(), {
    then: ({ object }) => (object.material = new THREE.MeshPhongMaterial({ color: 'orange' })),
  }),
  'a material array is assigned after a frame': makeRow(() => mesh(), {
    then({ object }) {
      object.geometry.clearGroups()
      object.geometry.addGroup(0, 9000, 0)
      object.geometry.addGroup(9000, Infinity, 1)
      object.material = [standard({ color: 'red' }), standard({ color: 'lime' })]
    },
  }),
  'scene.overrideMaterial is set': makeRow(() => mesh(), {
    after: ({ scene }) => void (scene.overrideMaterial = new THREE.MeshNormalMaterial()),
  }),
  'customDepthMaterial is set after the warp': makeRow(() => mesh(standard({ color: 'white' })), {
    shadow: true,
    after({ object }) {
      object.customDepthMaterial = new THREE.MeshDepthMaterial({
        depthPacking: THREE.RGBADepthPacking,
        alphaMap: checker(),
        alphaTest: 0.3,
      })
    },
  }),
  'mesh.onBeforeRender is set after the warp': makeRow(() => mesh(), {
    after({ object }) {
      object.onBeforeRender = (_renderer, _scene, _camera, _geometry, material) =>
        material.color.set('cyan')
    },
  }),
  'a child is added to a group': makeRow(() => makeGroup(makeSmallMesh()), {
    shadow: true,
    after({ object, way }) {
      const child = makeSmallMesh(0.7)
      child.castShadow = child.receiveShadow = true
      object.add(child)
      if (way === 'byHand') child.geometry = object.children[0].geometry
    },
  }),
  'the option share warps other meshes of the material': ({ put, way, renderer }) => {
    renderer.shadowMap.enabled = true
    const scene = litScene()
    const [first, second, late] = [-0.9, 0, 0.9].map((x) => {
      const made = makeSmallMesh(x)
      made.castShadow = made.receiveShadow = true
      return made
    })
    second.material = late.material = first.material
    scene.add(first, second)
    put(first, { share: true })
    if (way === 'byHand') second.geometry = late.geometry = first.geometry
    renderer.render(scene, camera())
    scene.add(late)
    renderer.render(scene, camera())
  },
  'a mesh is cloned': makeRow(
    () => makeSmallMesh(),
    withShadow(addClone((object) => object.clone())),
  ),
  'a group is cloned': makeRow(
    () => makeGroup(makeSmallMesh()),
    withShadow(addClone((object) => object.clone())),
  ),
  'a group is cloned by SkeletonUtils': makeRow(
    () => makeGroup(makeSmallMesh()),
    withShadow(addClone((object) => SkeletonUtils.clone(object))),
  ),
  'an InstancedMesh is cloned': makeRow(
    makeInstances,
    withShadow(addClone((object) => object.clone())),
  ),
  'an ArrayCamera draws it': makeRow(() => mesh(), {
    after() {
      const cameras = [0, 1].map((i) => {
        const made = camera()
        made.position.x += 0.3 * i
        made.updateMatrixWorld()
        made.viewport = new THREE.Vector4((i * size) / 2, 0, size / 2, size)
        return made
      })
      const made = new THREE.ArrayCamera(cameras)
      made.position.copy(camera().position)
      made.lookAt(0, 0, 0)
      return made
    },
  }),
  'a CubeCamera draws it': makeRow(() => mesh(), {
    after({ scene, renderer }) {
      const target = new THREE.WebGLCubeRenderTarget(64)
      const made = new THREE.CubeCamera(0.1, 20, target)
      made.position.z = 2
      scene.add(made)
      made.update(renderer, scene)
      scene.background = target.texture
    },
  }),
  ...(THREE.InstancedMesh.prototype.setMorphAt && {
    'instances have their own morph targets': makeRow(makeMorphingInstances),
  }),
  'two renderers draw it': ({ put }) => {
    const scene = litScene()
    const object = mesh()
    scene.add(object)
    put(object)
    const other = new THREE.WebGLRenderer({ preserveDrawingBuffer: true })
    other.setSize(size, size)
    for (const each of [renderer, other, renderer]) each.render(scene, camera())
    const pixels = readPixels(other)
    other.dispose()
    other.forceContextLoss()
    return pixels
  },
  'renderer.compile is called': makeRow(() => mesh(), {
    then: ({ scene, renderer }) => renderer.compile(scene, camera()),
  }),
}
