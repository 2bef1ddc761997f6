// The vertices of an object of three.js before it is warped, with its morph targets and bones.
import {
  Vector3,
  type BufferAttribute,
  type InterleavedBufferAttribute,
  type Line,
  type Mesh,
  type Points,
  type SkinnedMesh,
} from 'three'
import {
  attributeNumbers,
  variationAttribute,
  variationNames,
  type Vertices,
} from '../compile/hosts.js'

/** An object that can be warped. */
export type Warpable = Mesh | Points | Line

export type Attribute = BufferAttribute | InterleavedBufferAttribute

export const isSkinned = (object: Warpable): object is SkinnedMesh =>
  (object as SkinnedMesh).isSkinnedMesh === true

export const versionOf = (attribute: Attribute | undefined) =>
  attribute ? ('data' in attribute ? attribute.data.version : attribute.version) : -1

/** The influences that instances have each for itself. */
export const morphTextureOf = (object: Warpable) =>
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
  ]
  if (isSkinned(object))
    for (const { matrixWorld } of [...object.skeleton.bones, object])
      state.push(...matrixWorld.elements)
  return state
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
