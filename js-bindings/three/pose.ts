// An object of three.js before it is warped: its vertices, and boxes around them, with its morph targets and bones.
import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  type InstancedBufferGeometry,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  type Line,
  Matrix4,
  type Mesh,
  type Points,
  type SkinnedMesh,
  Sphere,
  Vector3,
} from 'three'
import {
  type Vertices,
  attributeNumbers,
  variationAttribute,
  variationNames,
} from '../compile/hosts.js'

/** An object that can be warped. */
export type Warpable = Mesh | Points | Line

type Attribute = BufferAttribute | InterleavedBufferAttribute

const isSkinned = (object: Warpable): object is SkinnedMesh =>
  (object as SkinnedMesh).isSkinnedMesh === true

const versionOf = (attribute: Attribute | undefined) =>
  attribute ? ('data' in attribute ? attribute.data.version : attribute.version) : -1

/** The influences that instances have each for itself. */
const morphTextureOf = (object: Warpable) =>
  (object as { morphTexture?: { version: number } | null }).morphTexture

/** Numbers that change when the vertices do. */
export function poseState(object: Warpable): number[] {
  const { attributes } = object.geometry
  const state = [
    object.geometry.id,
    ...Object.values(attributes).map((attribute) => versionOf(attribute as Attribute)),
    ...Object.values(object.geometry.morphAttributes).flat().map(versionOf),
    ...((object as Mesh).morphTargetInfluences ?? []),
    morphTextureOf(object)?.version ?? -1,
    ...boundsState(object.geometry),
  ]
  if (isSkinned(object))
    for (const { matrixWorld } of [...object.skeleton.bones, object])
      state.push(...matrixWorld.elements)
  return state
}

function boundsState(geometry: BufferGeometry): number[] {
  const sphere = ownBounds(geometry)?.sphere
  return sphere ? [...sphere.center.toArray(), sphere.radius] : []
}

/** The vertices as arrays: `isPosed` says whether morph targets and bones have moved them. */
export function verticesOf(object: Warpable, isPosed: boolean, fill: number[]): Vertices {
  const { geometry } = object
  const { position, normal, uv, color } = geometry.attributes
  const vertices: Record<string, Float32Array> = { positions: attributeNumbers(position!, 3) }
  if (normal) vertices.normals = attributeNumbers(normal, 3)
  if (uv) vertices.uvs = attributeNumbers(uv, 2)
  vertices.colors = colorsOf(object, color, position!.count, fill)
  for (const name of variationNames) {
    const attribute = geometry.attributes[variationAttribute(name)]
    if (attribute) vertices[`${name}s`] = attributeNumbers(attribute, 3)
  }
  if (isPosed && isMoved(object)) pose(object, vertices)
  return vertices as unknown as Vertices
}

function colorsOf(object: Warpable, color: Attribute | undefined, count: number, fill: number[]) {
  const [material] = [object.material].flat()
  if (color && material?.vertexColors) return attributeNumbers(color, 4, 1)
  const colors = new Float32Array(4 * count)
  for (let i = 0; i < count; i++) colors.set(fill, 4 * i)
  return colors
}

export const isMoved = (object: Warpable) =>
  isSkinned(object) || !!object.geometry.morphAttributes.position?.length

const place = new Vector3()
const origin = new Vector3()

function pose(object: Warpable, vertices: Record<string, Float32Array>) {
  const { positions, normals } = vertices
  const posed = new Float32Array(positions!.length)
  const turned = normals && morphed(object, normals)
  for (let i = 0; 3 * i < posed.length; i++) {
    ;(object as Mesh).getVertexPosition(i, place).toArray(posed, 3 * i)
    if (!turned || !isSkinned(object)) continue
    // Bones move a vertex affinely, and a direction as they move what it ends at, less what it starts from.
    object.applyBoneTransform(i, place.fromArray(turned, 3 * i))
    place.sub(object.applyBoneTransform(i, origin.set(0, 0, 0))).toArray(turned, 3 * i)
  }
  vertices.positions = posed
  if (turned) vertices.normals = turned
}

function morphed(object: Warpable, normals: Float32Array) {
  const { morphAttributes, morphTargetsRelative } = object.geometry
  const influences = (object as Mesh).morphTargetInfluences ?? []
  const turned = normals.slice()
  morphAttributes.normal?.forEach((attribute, target) => {
    const influence = influences[target] ?? 0
    if (influence === 0) return
    const to = attributeNumbers(attribute, 3)
    for (let i = 0; i < turned.length; i++)
      turned[i]! += influence * (to[i]! - (morphTargetsRelative ? 0 : normals[i]!))
  })
  return turned
}

/** Maps positions of geometries to their bounds at rest, for one version. */
const boxes = new WeakMap<object, { version: number; box: Box3; sphere: Sphere }>()

const boxOf = (attribute: Attribute): Box3 => boundsAtRest(attribute).box

/** Bounds of the geometry. Where instances of an InstancedBufferGeometry are, as of text, is known only to who sets its bounds. */
export const restBox = ({ geometry }: Warpable): Box3 =>
  ownBounds(geometry)?.box ?? boxOf(geometry.attributes.position as Attribute)
export const restSphere = ({ geometry }: Warpable): Sphere =>
  ownBounds(geometry)?.sphere ?? boundsAtRest(geometry.attributes.position as Attribute).sphere

function ownBounds(geometry: BufferGeometry) {
  const { isInstancedBufferGeometry } = geometry as Partial<InstancedBufferGeometry>
  const { boundingBox, boundingSphere } = geometry
  if (!isInstancedBufferGeometry || !boundingSphere) return undefined
  return { box: boundingBox ?? boundingSphere.getBoundingBox(new Box3()), sphere: boundingSphere }
}

function boundsAtRest(attribute: Attribute) {
  const version = versionOf(attribute)
  const known = boxes.get(attribute)
  if (known?.version === version) return known
  const positions = attributeNumbers(attribute, 3)
  const box = new Box3().setFromArray(positions)
  const center = box.getCenter(new Vector3())
  const sphere = new Sphere(center, box.isEmpty() ? -1 : farthest(positions, center))
  const made = { version, box, sphere }
  boxes.set(attribute, made)
  return made
}

// Plain numbers: of a large mesh this is a good part of the first frame.
function farthest(positions: Float32Array, from: Vector3): number {
  let most = 0
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i]! - from.x
    const y = positions[i + 1]! - from.y
    const z = positions[i + 2]! - from.z
    most = Math.max(most, x * x + y * y + z * z)
  }
  return Math.sqrt(most)
}

/** Bounds everything that morph targets make of the points in `box`, for all instances: never too small. */
function boxOfMorphs(object: Warpable, box: Box3): Box3 {
  const all = new Box3()
  for (const influences of influencesOf(object)) all.union(morphedBox(object, box, influences))
  return all
}

/** The influences of each instance; without instances those of the object. */
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
  const grown = scaled(box, base)
  targets.forEach((target, i) => {
    if (used[i] === 0) return
    const by = scaled(boxOf(target as BufferAttribute), used[i]!)
    grown.min.add(by.min)
    grown.max.add(by.max)
  })
  return grown
}

const scaled = ({ min, max }: Box3, factor: number) => {
  const [a, b] = [min.clone().multiplyScalar(factor), max.clone().multiplyScalar(factor)]
  return new Box3(a.clone().min(b), a.max(b))
}

/** Maps bones to boxes around the vertices at rest that they move; `undefined` if weights do not sum to 1. */
const bonesOf = new WeakMap<
  BufferGeometry,
  { version: string; boxes: Map<number, Box3> | undefined }
>()

function boxesOfBones(geometry: BufferGeometry) {
  const { position, skinIndex, skinWeight } = geometry.attributes as Record<string, Attribute>
  const version = [position, skinIndex, skinWeight].map(versionOf).join()
  const known = bonesOf.get(geometry)
  if (known?.version === version) return known.boxes
  let boxes: Map<number, Box3> | undefined = new Map<number, Box3>()
  const [indices, weights] = [attributeNumbers(skinIndex!, 4), attributeNumbers(skinWeight!, 4)]
  for (let i = 0; i < position!.count && boxes; i++) {
    place.fromBufferAttribute(position as BufferAttribute, i)
    let sum = 0
    for (let k = 4 * i; k < 4 * i + 4; k++) {
      sum += weights[k]!
      if (weights[k] === 0) continue
      const bone = indices[k]!
      if (!boxes.has(bone)) boxes.set(bone, new Box3())
      boxes.get(bone)!.expandByPoint(place)
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
    box.expandByPoint(object.getVertexPosition(i, place))
  return box
}

/** Bounds everything that morph targets and bones make of the points in a box. */
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
