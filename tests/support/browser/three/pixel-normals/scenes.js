// Objects for tests of normals at pixels, and their vertices before the warp.
import * as THREE from 'three'
import { variationAttributes } from './attributes.js'

/** The side of pictures, in pixels. A row of four floats per pixel is a multiple of 256 bytes, as WebGPU requires. */
export const size = 80

export const camera = () => {
  const made = new THREE.OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.1, 20)
  made.position.z = 8
  made.updateMatrixWorld()
  return made
}

const shapeGeometries = {
  sphere: () => new THREE.SphereGeometry(1, 24, 16),
  box: () => new THREE.BoxGeometry(1.2, 1.2, 1.2),
  torus: () => new THREE.TorusGeometry(0.8, 0.3, 12, 24),
  // 1,280 triangles.
  icosahedron: () => new THREE.IcosahedronGeometry(1, 7),
  plane: () => new THREE.PlaneGeometry(2, 2),
}

/** Rotates and scales an object unevenly, unless it is a plane. */
function place(object, isPlane) {
  if (!isPlane) {
    object.rotation.set(0.5, -0.4, 0.2)
    object.scale.set(1.1, 0.9, 1)
  }
  object.updateMatrixWorld()
  return object
}

/** The rotation of the bone. */
const boneRotation = new THREE.Euler(0.3, 0.7, 0)

/** Makes a mesh with a bone that rotates the whole geometry. */
function makeSkinnedMesh(geometry, material) {
  const { count } = geometry.attributes.position
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0))
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4))
  geometry.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4))
  const mesh = new THREE.SkinnedMesh(geometry, material)
  const bone = new THREE.Bone()
  mesh.add(bone)
  mesh.bind(new THREE.Skeleton([bone]))
  bone.rotation.copy(boneRotation)
  bone.updateMatrixWorld()
  return mesh
}

const boneMatrix = () => new THREE.Matrix4().makeRotationFromEuler(boneRotation)

/** Makes a mesh with a morph target that adds to positions and normals. */
function makeMorphingMesh(geometry, material) {
  const targets = makeMorphTargets(geometry)
  Object.assign(geometry.morphAttributes, targets)
  geometry.morphTargetsRelative = true
  const mesh = new THREE.Mesh(geometry, material)
  mesh.morphTargetInfluences = [0.7]
  return mesh
}

function makeMorphTargets({ attributes }) {
  const makeTarget = (name, amount) => {
    const numbers = Float32Array.from(attributes[name].array, (_, i) => {
      const [y, z] = [attributes.position.getY((i / 3) | 0), attributes.position.getZ((i / 3) | 0)]
      return i % 3 === 0 ? amount * y : i % 3 === 1 ? amount * z * z : 0
    })
    return [new THREE.BufferAttribute(numbers, 3)]
  }
  return { position: makeTarget('position', 0.3), normal: makeTarget('normal', -0.3) }
}

/** The matrices of two instances, with uneven scales. */
export const instances = [
  [-0.8, 0.2],
  [0.8, -0.3],
].map(([x, y], i) =>
  new THREE.Matrix4().compose(
    new THREE.Vector3(x, y, 0),
    new THREE.Quaternion().setFromEuler(new THREE.Euler(0.4 * i, 0.6, 0.3)),
    new THREE.Vector3(0.4, 0.6, 0.35 + 0.1 * i),
  ),
)

function makeInstancedMesh(geometry, material) {
  const mesh = new THREE.InstancedMesh(geometry, material, 2)
  instances.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
  return mesh
}

function makeBatchedMesh(geometry, material) {
  const mesh = new THREE.BatchedMesh(2, 4000, 12000, material)
  // Both instances share a geometry: geometries with different attributes would not fit into one batch.
  const id = mesh.addGeometry(geometry)
  for (const matrix of instances) mesh.setMatrixAt(mesh.addInstance(id), matrix)
  return mesh
}

/**
 * Maps the name of a case → a function that makes its object. `pose(name, numbers, geometry)` computes positions or normals before
 * the warp, if they differ from those of the geometry. `matrices` are those of the instances.
 */
export const kinds = {
  plain: { make: (geometry, material) => new THREE.Mesh(geometry, material) },
  'negative scale': {
    make(geometry, material) {
      const mesh = new THREE.Mesh(geometry, material)
      mesh.userData.mirrored = true
      return mesh
    },
  },
  skin: {
    make: makeSkinnedMesh,
    pose: (_, numbers) => transformPoints(numbers, boneMatrix()),
  },
  morphs: {
    make: makeMorphingMesh,
    pose(name, numbers, geometry) {
      const [{ array }] = makeMorphTargets(geometry)[name]
      return numbers.map((x, i) => x + 0.7 * array[i])
    },
  },
  instances: { make: makeInstancedMesh, matrices: instances },
  batch: { make: makeBatchedMesh, matrices: instances },
}

function transformPoints(numbers, matrix) {
  const vector = new THREE.Vector3()
  const moved = new Float32Array(numbers.length)
  for (let i = 0; i < numbers.length; i += 3)
    vector.fromArray(numbers, i).applyMatrix4(matrix).toArray(moved, i)
  return moved
}

/** Makes a positioned object, and returns it with the geometry that has its vertices. */
export function makeObject(kind, shape, material) {
  const geometry = shapeGeometries[shape]()
  const object = place(kinds[kind].make(geometry, material), shape === 'plane')
  if (object.userData.mirrored) {
    object.scale.x *= -1
    object.updateMatrixWorld()
  }
  return { object, geometry: object.isBatchedMesh ? geometry : object.geometry }
}

/** Returns an attribute before the warp as four floats per vertex, to draw it. The fourth number of a normal is its length. */
export function readUnwarped(kind, geometry, name) {
  const { count } = geometry.attributes.position
  const numbers = new Float32Array(4 * count)
  const attribute = geometry.attributes[variationAttributes[name] ?? name]
  if (!attribute) return numbers
  const plain = Float32Array.from({ length: count * attribute.itemSize }, (_, i) =>
    attribute[['getX', 'getY', 'getZ', 'getW'][i % attribute.itemSize]](
      (i / attribute.itemSize) | 0,
    ),
  )
  const { pose } = kinds[kind]
  const values =
    pose && (name === 'normal' || name === 'position') ? pose(name, plain, geometry) : plain
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < attribute.itemSize; k++)
      numbers[4 * i + k] = values[attribute.itemSize * i + k]
    if (name === 'position') numbers[4 * i + 3] = 1
    if (name === 'normal') numbers[4 * i + 3] = Math.hypot(...numbers.subarray(4 * i, 4 * i + 3))
  }
  return numbers
}

/** Offsets that collapse the surface, so that its normal is zero. */
export const collapses = {
  floor: ({ position }) => position.mult(3).floor().div(3).sub(position),
  pinch: ({ glsl, position }) =>
    glsl.vec3(0, 1.2, 0).sub(position).mult(glsl.step(0.3, position.y())),
}

/** The attributes that `readUnwarped` reads. */
export const attributeNames = [
  'position',
  'normal',
  'uv',
  'tangent',
  ...Object.keys(variationAttributes),
]
