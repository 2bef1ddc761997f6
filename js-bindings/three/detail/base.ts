/** Reads a geometry of three.js as the base of a `DetailedMesh`, and how its arrays are distributed over buffers. */
import type { BufferAttribute, BufferGeometry, InterleavedBuffer, Mesh } from 'three'
import { attributeNumbers } from '../../compile/hosts.js'
import type { DetailAttribute, DetailBase } from '../../detail/detailed-mesh.js'
import type { Attribute } from '../attribute.js'
import { isSkinned, poseArrays, verticesOf, type Poseable } from '../pose.js'
import { fillOf } from '../surface.js'
import type { ThreeWarp } from '../three-warp.js'

/** An attribute of a buffer. */
export interface Column {
  readonly name: string
  readonly size: number
  /** Its index in `DetailBase.attributes`; -1 is positions. */
  readonly attribute: number
}

/** A group of triangles with a material. */
export interface Group {
  readonly materialIndex: number | undefined
}

export interface GeometryBase extends DetailBase {
  readonly positions: Float32Array
  /** The columns of each buffer. Attributes that share a buffer in the user's geometry also share one here: WebGPU allows 8 buffers. */
  readonly buffers: readonly (readonly Column[])[]
  /** The attributes of instances, which stay as they are. */
  readonly ofInstances: Readonly<Record<string, Attribute>>
  /** One for each entry of `groups`; empty for a mesh with one material. */
  readonly materials: readonly Group[]
  /** Maps a triangle → its index in the user's geometry. */
  readonly faces: readonly number[]
}

/** The numbers per vertex that all shaders expect. */
const sizes: Record<string, number> = { position: 3, normal: 3, uv: 2 }

const inputs: Record<string, DetailAttribute['input']> = { normal: 'normals', uv: 'uvs' }

/** Reads the arrays of a mesh at rest. Bones move the mesh before it is divided, so the attributes of bones are left out. All numbers become floats. A tangent is interpolated as four plain numbers, since shaders normalize it. */
export function baseOf(warp: ThreeWarp, object: Mesh): GeometryBase {
  const { geometry, material } = object
  const positions = attributeNumbers(geometry.attributes.position!, 3)
  const attributes: DetailAttribute[] = []
  const buffers = new Map<object, Column[]>()
  const ofInstances: Record<string, Attribute> = {}
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (isOfInstances(attribute)) {
      ofInstances[name] = attribute
      continue
    }
    if (isSkinned(object) && isOfBones(name)) continue
    const size = sizes[name] ?? attribute.itemSize
    const shared = 'data' in attribute ? attribute.data : attribute
    if (!buffers.has(shared)) buffers.set(shared, [])
    const isPosition = name === 'position'
    buffers.get(shared)!.push({ name, size, attribute: isPosition ? -1 : attributes.length })
    if (isPosition) continue
    const values = attributeNumbers(attribute, size)
    attributes.push({ input: inputs[name], size, values, isUnit: name === 'normal' })
  }
  if (warp.reads('color')) {
    const { colors } = verticesOf(object, false, fillOf(material))
    attributes.push({ input: 'colors', size: 4, values: colors! })
  }
  return {
    positions,
    attributes,
    buffers: [...buffers.values()],
    ofInstances,
    ...trianglesOf(geometry, Array.isArray(material)),
  }
}

/** Tests for an attribute that determines how bones move vertices. */
export const isOfBones = (name: string) => name === 'skinIndex' || name === 'skinWeight'

/** Returns the mesh as morph targets and bones have moved it. */
export function poseBase(base: GeometryBase, object: Mesh): GeometryBase {
  const indices = new Map(base.buffers.flat().map(({ name, attribute }) => [name, attribute]))
  const rest: Poseable = { position: base.positions }
  for (const name of posedNames) {
    const values = base.attributes[indices.get(name) ?? -1]?.values
    if (values) rest[name] = values as Float32Array
  }
  const { position, ...others } = poseArrays(object, rest)
  const attributes = [...base.attributes]
  for (const [name, values] of Object.entries(others)) {
    const index = indices.get(name)!
    attributes[index] = { ...attributes[index]!, values }
  }
  return { ...base, positions: position!, attributes }
}

const posedNames = ['normal', 'tangent', 'color'] as const

export const isOfInstances = (attribute: Attribute) =>
  'data' in attribute
    ? (attribute.data as InterleavedBuffer & Flags).isInstancedInterleavedBuffer === true
    : (attribute as BufferAttribute & Flags).isInstancedBufferAttribute === true

type Flags = Partial<Record<`isInstanced${'Interleaved' | ''}Buffer${'Attribute' | ''}`, boolean>>

/** Returns the triangles that three.js draws: those of each group if there are several materials. Groups may overlap. */
function trianglesOf({ index, attributes, groups, drawRange }: BufferGeometry, hasGroups: boolean) {
  const all = index ? attributeNumbers(index, 1) : undefined
  const count = all?.length ?? attributes.position!.count
  const drawn = { ...drawRange, materialIndex: undefined }
  const indices: number[] = []
  const faces: number[] = []
  const starts: number[] = []
  const materials: Group[] = []
  for (const range of hasGroups ? groups : [drawn]) {
    const start = Math.max(range.start, drawRange.start, 0)
    const end = Math.min(range.start + range.count, drawRange.start + drawRange.count, count)
    starts.push(indices.length / 3)
    materials.push({ materialIndex: range.materialIndex })
    for (let i = start; i + 3 <= end; i += 3) {
      faces.push(Math.floor(i / 3))
      for (let k = i; k < i + 3; k++) indices.push(all ? all[k]! : k)
    }
  }
  return { indices, faces, ...(hasGroups ? { groups: starts, materials } : { materials: [] }) }
}
