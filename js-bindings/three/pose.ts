// The vertices of an object of three.js before it is warped, with its morph targets and bones.
import type { Line, Mesh, Points, SkinnedMesh } from 'three'
import {
  attributeNumbers,
  variationAttribute,
  variationNames,
  type Vertices,
} from '../compile/hosts.js'
import { versionOf, type Attribute } from './attribute.js'
import { moveByBones } from './skinning.js'

/** An object that can be warped. */
export type Warpable = Mesh | Points | Line

export const isSkinned = (object: Warpable): object is SkinnedMesh =>
  (object as SkinnedMesh).isSkinnedMesh === true

/** Returns the texture with each instance's own influences of morph targets, if the object has one. */
export const morphTextureOf = (object: Warpable) =>
  (object as { morphTexture?: { version: number } | null }).morphTexture

/** Returns numbers that change when the vertices change. */
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

/** Returns the vertices as arrays: after morph targets and bones if `isPosed` is true, otherwise before them. */
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
  if (isPosed && isMoved(object)) {
    const posed = poseArrays(object, {
      position: vertices.positions,
      ...(vertices.normals && { normal: vertices.normals }),
    })
    vertices.positions = posed.position!
    if (posed.normal) vertices.normals = posed.normal
  }
  return vertices as unknown as Vertices
}

function colorsOf(object: Warpable, color: Attribute | undefined, count: number, fill: number[]) {
  const [material] = [object.material].flat()
  if (color && material?.vertexColors) return attributeNumbers(color, 4, 1)
  const colors = new Float32Array(4 * count)
  for (let i = 0; i < count; i++) colors.set(fill, 4 * i)
  return colors
}

/** Tests whether morph targets or bones move the vertices. */
export const isMoved = (object: Warpable) =>
  isSkinned(object) || !!object.geometry.morphAttributes.position?.length

/** Arrays that morph targets or bones move, by the names of their attributes. */
export type Poseable = Partial<Record<'position' | 'normal' | 'tangent' | 'color', Float32Array>>

/** Returns the arrays after morph targets and bones. Each array has all numbers of its attribute. */
export function poseArrays(object: Warpable, arrays: Poseable): Poseable {
  const posed: Poseable = {}
  for (const name of ['position', 'normal', 'tangent', 'color'] as const)
    if (arrays[name]) posed[name] = applyMorphs(object, name, arrays[name])
  if (!isSkinned(object)) return posed
  const { position, normal, tangent } = posed
  moveByBones(object, position ? [position] : [], [normal, tangent].filter(isPresent))
  return posed
}

const isPresent = (array: Float32Array | undefined) => array !== undefined

/** Returns a copy of an array, moved by morph targets, of which three.js has none for tangents. */
function applyMorphs(object: Warpable, name: keyof Poseable, rest: Float32Array): Float32Array {
  const { morphAttributes, morphTargetsRelative, attributes } = object.geometry
  const influences = (object as Mesh).morphTargetInfluences ?? []
  const size = rest.length / attributes.position!.count
  const moved = rest.slice()
  const targets = (morphAttributes as Partial<Record<string, Attribute[]>>)[name]
  targets?.forEach((attribute, target) => {
    const influence = influences[target] ?? 0
    if (influence === 0) return
    const values = attributeNumbers(attribute, size)
    for (let i = 0; i < moved.length; i++)
      moved[i]! += influence * (values[i]! - (morphTargetsRelative ? 0 : rest[i]!))
  })
  return moved
}
