// Instances and bones: which objects have such matrices, and when three.js applies them.
import type { BufferGeometry, Texture } from 'three'
import type { Builder } from './builder.js'
import { tsl, type AnyNode } from './tsl.js'

/** Runs `work` while a material has no positionNode. */
export function withoutPositionNode(material: { positionNode: unknown }, work: () => void) {
  const { positionNode } = material
  material.positionNode = null
  try {
    work()
  } finally {
    material.positionNode = positionNode
  }
}

/** Runs three.js' own `setup` such that it leaves out the matrices of instances and the positionNode. */
export function withoutInstances(
  builder: Builder,
  material: { positionNode: unknown },
  setup: () => void,
) {
  const { object } = builder
  const isFalse = { value: false }
  builder.object = Object.create(object, { isInstancedMesh: isFalse, isBatchedMesh: isFalse })
  try {
    withoutPositionNode(material, setup)
  } finally {
    builder.object = object
  }
}

interface Kind {
  isSkinnedMesh?: boolean
  isInstancedMesh?: boolean
  isBatchedMesh?: boolean
  instanceMatrix?: { isInstancedBufferAttribute?: boolean }
  _matricesTexture?: Texture
  geometry?: BufferGeometry
}

export const isSkinned = (object: object) => (object as Kind).isSkinnedMesh === true

/** Tests whether three.js has applied matrices of the previous frame to `positionPrevious`. */
export const isPosed = (object: object) => isSkinned(object) || instancesOf(object) !== undefined

/** Returns the TSL function that applies the matrices of instances; `undefined` for an object that has none. */
export function instancesOf(object: object) {
  const { isBatchedMesh, isInstancedMesh, instanceMatrix } = object as Kind
  if (isBatchedMesh) return tsl.batch
  // Three.js leaves other matrices to the user, such as those that compute shaders write.
  const isOfThree = isInstancedMesh && instanceMatrix?.isInstancedBufferAttribute
  return isOfThree ? tsl.instancedMesh : undefined
}

/** Returns the TSL function that applies the matrices of instances if three.js applies them after the warp; otherwise `undefined`. */
export const instancesAfter = (
  { space, isAfterInstances }: { space: string; isAfterInstances?: boolean },
  object: object,
) => (space === 'world' || isAfterInstances ? undefined : instancesOf(object))

/** The number of attributes that a vertex shader can read. */
const maxAttributes = 16

/**
 * Returns a function that returns the node of an instance's matrix; call it once three.js has applied the matrix. Returns `undefined` if
 * the matrix cannot be read a second time, as where too few attributes are left.
 */
export function instanceMatrixOf(object: object): (() => AnyNode) | undefined {
  const { isBatchedMesh, _matricesTexture, geometry } = object as Kind
  const { batchIndirectIndex, referenceAttribute } = tsl
  if (isBatchedMesh)
    return batchIndirectIndex && _matricesTexture
      ? () => matrixInTexture(_matricesTexture, batchIndirectIndex)
      : undefined
  // A matrix takes four attributes, and three.js reads the matrix once already.
  const count = Object.keys(geometry!.attributes).length + 8
  return referenceAttribute && count <= maxAttributes
    ? () => referenceAttribute('instanceMatrix', 'mat4')
    : undefined
}

/** Reads the first three columns of a matrix from a batch's texture, which has four texels per matrix. */
function matrixInTexture(texture: Texture, index: AnyNode): AnyNode {
  const width = tsl.int(tsl.textureSize(tsl.textureLoad(texture), 0).x)
  const first = tsl.int(index).mul(4).toVar()
  const columns = [0, 1, 2].map((i) => {
    const texel = first.add(i)
    return tsl.textureLoad(texture, tsl.ivec2(texel.mod(width), texel.div(width))).xyz
  })
  return tsl.mat3(...columns)
}
