// Moves vertices by bones on the CPU, as shaders of three.js do.
import { Matrix4, type SkinnedMesh } from 'three'
import { attributeNumbers } from '../compile/hosts.js'
import { versionOf, type Attribute } from './attribute.js'

/**
 * Moves places and directions in place, each by the sum of the matrices of its vertex's bones, times their weights. Of each vertex, the
 * first three numbers are moved.
 */
export function moveByBones(
  object: SkinnedMesh,
  places: readonly Float32Array[],
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
    for (const each of places) move(each, (each.length / count) * vertex, sum, 1)
    for (const each of directions) move(each, (each.length / count) * vertex, sum, 0)
  }
}

/** Multiplies the vector at this place of an array, with `w` as its fourth number, by a matrix. */
function move(values: Float32Array, at: number, m: Float64Array, w: 0 | 1) {
  const x = values[at]!
  const y = values[at + 1]!
  const z = values[at + 2]!
  for (let row = 0; row < 3; row++)
    values[at + row] = m[row]! * x + m[4 + row]! * y + m[8 + row]! * z + m[12 + row]! * w
}

const ofBone = new Matrix4()

/** The matrices of all bones, from the space of the geometry to itself, by columns. */
function matricesOf({ skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh): Float64Array {
  const { bones, boneInverses } = skeleton
  const all = new Float64Array(16 * bones.length)
  bones.forEach((bone, i) => {
    ofBone.copy(bindMatrixInverse)
    // Three.js takes the identity for a missing bone.
    if (bone) ofBone.multiply(bone.matrixWorld)
    ofBone.multiply(boneInverses[i]!).multiply(bindMatrix)
    all.set(ofBone.elements, 16 * i)
  })
  return all
}

const read = new WeakMap<Attribute, { readonly version: number; readonly numbers: Float32Array }>()

/** The numbers of an attribute, which are read again only if it changes. */
function numbersOf(attribute: Attribute): Float32Array {
  const version = versionOf(attribute)
  let found = read.get(attribute)
  if (found?.version !== version)
    read.set(attribute, (found = { version, numbers: attributeNumbers(attribute, 4) }))
  return found.numbers
}
