// Boxes and spheres around an object before it is warped: at rest, and with its morph targets and bones.
import {
  Box3,
  Matrix4,
  Sphere,
  Vector3,
  type BufferAttribute,
  type BufferGeometry,
  type InstancedBufferGeometry,
  type InstancedMesh,
  type Mesh,
  type SkinnedMesh,
} from 'three'
import { attributeNumbers } from '../compile/hosts.js'
import { versionOf, type Attribute } from './attribute.js'
import { isMoved, isSkinned, morphTextureOf, type Warpable } from './pose.js'

/** Returns numbers that change when the user sets other bounds of an InstancedBufferGeometry. */
export function boundsState({ geometry }: Warpable): number[] {
  const sphere = boundsSetByUser(geometry)?.sphere
  return sphere ? [...sphere.center.toArray(), sphere.radius] : []
}

/** Maps the attribute `position` of a geometry, or of a morph target → its bounds, for one version of the attribute. */
const boxes = new WeakMap<object, { version: number; box: Box3; sphere: Sphere }>()

const boxOf = (attribute: Attribute): Box3 => boundsAtRest(attribute).box

/**
 * Returns bounds of the geometry. Instances of an InstancedBufferGeometry, as of text, can be anywhere: only the bounds that the user sets
 * include them.
 */
export const restBox = ({ geometry }: Warpable): Box3 =>
  boundsSetByUser(geometry)?.box ?? boxOf(geometry.attributes.position as Attribute)
export const restSphere = ({ geometry }: Warpable): Sphere =>
  boundsSetByUser(geometry)?.sphere ??
  boundsAtRest(geometry.attributes.position as Attribute).sphere

function boundsSetByUser(geometry: BufferGeometry) {
  const { isInstancedBufferGeometry } = geometry as Partial<InstancedBufferGeometry>
  const { boundingBox, boundingSphere } = geometry
  if (!isInstancedBufferGeometry || !boundingSphere) return undefined
  return { box: boundingBox ?? boundingSphere.getBoundingBox(new Box3()), sphere: boundingSphere }
}

function boundsAtRest(attribute: Attribute) {
  const version = versionOf(attribute)
  const cached = boxes.get(attribute)
  if (cached?.version === version) return cached
  const positions = attributeNumbers(attribute, 3)
  const box = new Box3().setFromArray(positions)
  const center = box.getCenter(new Vector3())
  const sphere = new Sphere(center, box.isEmpty() ? -1 : farthest(positions, center))
  const bounds = { version, box, sphere }
  boxes.set(attribute, bounds)
  return bounds
}

// Uses plain numbers, since this takes a considerable part of the first frame of a large mesh.
function farthest(positions: Float32Array, from: Vector3): number {
  let max = 0
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i]! - from.x
    const y = positions[i + 1]! - from.y
    const z = positions[i + 2]! - from.z
    max = Math.max(max, x * x + y * y + z * z)
  }
  return Math.sqrt(max)
}

/** Returns a box, never too small, around all positions to which morph targets move points of `box`, in all instances. */
function boxOfMorphs(object: Warpable, box: Box3): Box3 {
  const all = new Box3()
  for (const influences of influencesOf(object)) all.union(morphedBox(object, box, influences))
  return all
}

/** Returns the influences of each instance; without instances those of the object. */
function influencesOf(object: Warpable): number[][] {
  if (!morphTextureOf(object)) return [(object as Mesh).morphTargetInfluences ?? []]
  const { count } = object as InstancedMesh
  const targets = object.geometry.morphAttributes.position ?? []
  return Array.from({ length: count }, (_, i) => {
    const target = { morphTargetInfluences: targets.map(() => 0) }
    ;(object as InstancedMesh).getMorphAt(i, target as never)
    return target.morphTargetInfluences
  })
}

function morphedBox({ geometry }: Warpable, box: Box3, influences: number[]): Box3 {
  const { morphAttributes, morphTargetsRelative } = geometry
  const targets = morphAttributes.position ?? []
  const used = targets.map((_, i) => influences[i] ?? 0)
  const base = morphTargetsRelative ? 1 : 1 - used.reduce((sum, influence) => sum + influence, 0)
  const grown = scaleBox(box, base)
  targets.forEach((target, i) => {
    if (used[i] === 0) return
    const change = scaleBox(boxOf(target as BufferAttribute), used[i]!)
    grown.min.add(change.min)
    grown.max.add(change.max)
  })
  return grown
}

const scaleBox = ({ min, max }: Box3, factor: number) => {
  const [a, b] = [min.clone().multiplyScalar(factor), max.clone().multiplyScalar(factor)]
  return new Box3(a.clone().min(b), a.max(b))
}

const point = new Vector3()

/** Maps geometries → for each bone, a box around the vertices at rest that it moves; `boxes` is `undefined` if weights do not sum to 1. */
const bonesOf = new WeakMap<
  BufferGeometry,
  { version: string; boxes: Map<number, Box3> | undefined }
>()

function boxesOfBones(geometry: BufferGeometry) {
  const { position, skinIndex, skinWeight } = geometry.attributes as Record<string, Attribute>
  const version = [position, skinIndex, skinWeight].map(versionOf).join()
  const cached = bonesOf.get(geometry)
  if (cached?.version === version) return cached.boxes
  let boxes: Map<number, Box3> | undefined = new Map<number, Box3>()
  const [indices, weights] = [attributeNumbers(skinIndex!, 4), attributeNumbers(skinWeight!, 4)]
  for (let i = 0; i < position!.count && boxes; i++) {
    point.fromBufferAttribute(position as BufferAttribute, i)
    let sum = 0
    for (let k = 4 * i; k < 4 * i + 4; k++) {
      sum += weights[k]!
      if (weights[k] === 0) continue
      const bone = indices[k]!
      if (!boxes.has(bone)) boxes.set(bone, new Box3())
      boxes.get(bone)!.expandByPoint(point)
    }
    if (Math.abs(sum - 1) > 1e-3) boxes = undefined
  }
  bonesOf.set(geometry, { version, boxes })
  return boxes
}

const toBone = new Matrix4()

/** Bounds the object after morph targets and bones, before its own matrix: never too small. */
export function posedBox(object: Warpable): Box3 {
  const rest = restBox(object)
  if (!isSkinned(object)) return isMoved(object) ? boxOfMorphs(object, rest) : rest
  const isMorphed = !!object.geometry.morphAttributes.position?.length
  const boxes = isMorphed ? undefined : boxesOfBones(object.geometry)
  if (boxes) return throughBones(object, boxes)
  const box = new Box3()
  for (let i = 0; i < object.geometry.attributes.position!.count; i++)
    box.expandByPoint(object.getVertexPosition(i, point))
  return box
}

/** Returns a box around all positions to which morph targets and bones move points of a box. */
export function posedFrom(object: Warpable, box: Box3): Box3 {
  const morphed = boxOfMorphs(object, box)
  if (!isSkinned(object)) return morphed
  const boxes = boxesOfBones(object.geometry)
  const bones = boxes ? [...boxes.keys()] : object.skeleton.bones.map((_, i) => i)
  return throughBones(object, new Map(bones.map((bone) => [bone, morphed])))
}

function throughBones(
  { skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh,
  boxes: Map<number, Box3>,
) {
  const all = new Box3()
  for (const [i, box] of boxes) {
    const bone = skeleton.bones[i]
    if (!bone) continue
    toBone
      .multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[i]!)
      .premultiply(bindMatrixInverse)
      .multiply(bindMatrix)
    all.union(box.clone().applyMatrix4(toBone))
  }
  return all
}
