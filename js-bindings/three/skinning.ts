// Moves vertices by bones on the CPU, as shaders of three.js do.
import { Matrix4, type SkinnedMesh } from 'three'
import { attributeNumbers } from '../compile/hosts.js'
import { versionOf, type Attribute } from './attribute.js'

/**
 * Transforms positions and directions in place, each by the weighted sum of the matrices of its vertex's bones. In each array, the first
 * three numbers of a vertex are transformed.
 */
export function moveByBones(
  object: SkinnedMesh,
  positions: readonly Float32Array[],
  directions: readonly Float32Array[],
) {
  const { skinIndex, skinWeight } = object.geometry.attributes
  if (!skinIndex || !skinWeight) return
  const [indices, weights] = [numbersOf(skinIndex), numbersOf(skinWeight)]
  const matrices = matricesOf(object)
  const { count } = skinIndex
  const sum = new Float64Array(16)
  for (let vertex = 0; vertex < count; vertex++) {
    sum.fill(0)
    for (let k = 4 * vertex; k < 4 * vertex + 4; k++) {
      const weight = weights[k]!
      const start = 16 * indices[k]!
      if (weight !== 0) for (let i = 0; i < 16; i++) sum[i]! += weight * matrices[start + i]!
    }
    for (const each of positions) transform(each, (each.length / count) * vertex, sum, 1)
    for (const each of directions) transform(each, (each.length / count) * vertex, sum, 0)
  }
}

/** Multiplies the vector that starts at `start` in an array, with `w` as its fourth number, by a matrix. */
function transform(values: Float32Array, start: number, m: Float64Array, w: 0 | 1) {
  const x = values[start]!
  const y = values[start + 1]!
  const z = values[start + 2]!
  for (let row = 0; row < 3; row++)
    values[start + row] = m[row]! * x + m[4 + row]! * y + m[8 + row]! * z + m[12 + row]! * w
}

const boneMatrix = new Matrix4()

/** Returns the matrices of all bones, which transform within the space of the geometry, column by column. */
function matricesOf({ skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh): Float64Array {
  const { bones, boneInverses } = skeleton
  const all = new Float64Array(16 * bones.length)
  bones.forEach((bone, i) => {
    boneMatrix.copy(bindMatrixInverse)
    // Three.js uses the identity for a missing bone.
    if (bone) boneMatrix.multiply(bone.matrixWorld)
    boneMatrix.multiply(boneInverses[i]!).multiply(bindMatrix)
    all.set(boneMatrix.elements, 16 * i)
  })
  return all
}

const cache = new WeakMap<Attribute, { readonly version: number; readonly numbers: Float32Array }>()

/** Returns the numbers of an attribute, which are read again only if it changes. */
function numbersOf(attribute: Attribute): Float32Array {
  const version = versionOf(attribute)
  let found = cache.get(attribute)
  if (found?.version !== version)
    cache.set(attribute, (found = { version, numbers: attributeNumbers(attribute, 4) }))
  return found.numbers
}
