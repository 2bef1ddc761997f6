// Meshes as flat arrays: their types, and how they are checked and copied into a job and out of it.
import { arraysOf, isGeometry, type Geometry } from '../core/inputs/geometry.js'
import { describe } from '../errors/errors.js'
import { isList } from '../options/guards.js'
import { kind, record, text } from '../options/kinds.js'
import { describeNumber, finiteFloat, firstWrong } from '../options/numbers.js'
import type { Place } from '../options/place.js'
import type { FloatArray } from '../wasm/mesh-tables.js'
import type { Job } from './job.js'

/** An image file. */
export interface Picture {
  /** PNG or JPEG. */
  bytes: Uint8Array
  mimeType: string
}

export interface Material {
  /** Linear red, green, blue and alpha from 0 to 1; multiplies the texture. */
  baseColor: number[]
  baseColorTexture?: Picture
  /** A normal map in tangent space, as in glTF: green is up. `bakeNormalMap` makes one; `loadMesh` leaves out the one in a file. */
  normalTexture?: Picture
}

/** A triangle mesh as the functions of this module return it. */
export interface Mesh {
  /** 3 numbers per vertex. */
  positions: Float32Array
  /** 3 numbers per vertex: a vector of length 1, or of length 0 where the surface has no normal. */
  normals: Float32Array
  /** 2 numbers per vertex, from the image's top left corner. */
  uvs?: Float32Array
  /** 4 numbers per vertex: linear red, green, blue and alpha from 0 to 1. */
  colors?: Float32Array
  /** 4 numbers per vertex: a direction, and 1 or -1 for the side of the bitangent, as in glTF. */
  tangents?: Float32Array
  /** 3 indices per triangle; without indices, every 3 vertices are a triangle. */
  indices?: Uint32Array
  material?: Material
  /** Messages about parts of a file that were left out or corrected. */
  warnings?: string[]
}

/** A triangle mesh as the functions of this module accept it: with arrays of any kind, and optional normals. */
export interface MeshInput {
  positions: ArrayLike<number>
  normals?: ArrayLike<number>
  uvs?: ArrayLike<number>
  colors?: ArrayLike<number>
  tangents?: ArrayLike<number>
  indices?: ArrayLike<number>
  material?: {
    baseColor?: ArrayLike<number>
    baseColorTexture?: { bytes: Uint8Array; mimeType?: string }
    normalTexture?: { bytes: Uint8Array; mimeType?: string }
  }
}

export const floatArrays: readonly FloatArray[] = [
  'positions',
  'normals',
  'uvs',
  'colors',
  'tangents',
]

const sizes: Partial<Record<FloatArray, number>> = { uvs: 2, colors: 4, tangents: 4 }

/** A mesh, or a geometry of three.js. */
export type MeshOrGeometry = MeshInput | Geometry

/** Converts a geometry to a mesh; returns other values unchanged. */
function meshOf(place: Place, value: unknown): unknown {
  if (!isGeometry(value)) return value
  if (value.attributes.position) return arraysOf(value)
  throw place.error('the geometry has no attribute "position".')
}

/** Copies a mesh or a geometry into the job. Throws a `WarpError` if it is neither or its arrays do not fit together. */
export function putMesh(job: Job, meshOrGeometry: unknown) {
  const { place } = job
  const mesh = meshOf(place, meshOrGeometry)
  if (!isObject(mesh) || !('positions' in mesh))
    throw place.expected('a mesh such as { positions, normals, indices }', describe(meshOrGeometry))
  for (const name of floatArrays) {
    const numbers = mesh[name]
    if (numbers === undefined && name !== 'positions') continue
    // C++ checks that the numbers are finite.
    job.setFloats(name, flatArray.read(numbers, place.part(name)), sizes[name])
  }
  if (mesh.indices !== undefined) job.setIndices(indicesOf(mesh.indices, place))
  if (mesh.material !== undefined) putMaterial(job, mesh.material, place)
  job.act('checkMesh')
}

const flatArray = kind<ArrayLike<number>>(
  'a flat array of numbers, such as a Float32Array,',
  isList,
)

function indicesOf(value: unknown, place: Place): ArrayLike<number> {
  const numbers = flatArray.read(value, place.part('indices'))
  if (numbers instanceof Uint32Array || numbers instanceof Uint16Array) return numbers
  for (let i = 0; i < numbers.length; i++) {
    const index: unknown = numbers[i]
    if (!(Number.isInteger(index) && (index as number) >= 0 && (index as number) < 2 ** 32))
      throw place
        .part(`indices[${i}]`)
        .expected('the number of a vertex, counted from 0,', describe(index))
  }
  return numbers
}

/** The textures of a material, and their arrays in a job. */
const textures = [
  { name: 'baseColorTexture', arrays: { bytes: 'baseColorImage', mimeType: 'baseColorMimeType' } },
  { name: 'normalTexture', arrays: { bytes: 'normalImage', mimeType: 'normalMimeType' } },
] as const

const materialKind = record<Record<string, unknown>>(
  'an object such as { baseColor: [1, 1, 1, 1] }',
)
const mimeTypeKind = text('a text such as "image/png"', undefined, { default: '' })

function putMaterial(job: Job, value: unknown, place: Place) {
  const part = (name: string) => place.part(`material.${name}`)
  const material = materialKind.read(value, place.part('material'))
  const { baseColor = [1, 1, 1, 1] } = material
  const color = flatArray.read(baseColor, part('baseColor'))
  if (color.length !== 4 || firstWrong(color, finiteFloat) >= 0)
    throw part('baseColor').expected(
      'four finite numbers, red, green, blue and alpha,',
      `[${Array.from(color).slice(0, 5).map(describeNumber).join(', ')}]`,
    )
  job.setBaseColor(color)
  for (const { name, arrays } of textures) {
    const texture = material[name]
    if (texture === undefined) continue
    const { bytes, mimeType } = isObject(texture) ? texture : {}
    if (!(bytes instanceof Uint8Array))
      throw part(name).expected(
        '{ bytes, mimeType } with bytes in a Uint8Array',
        isObject(texture) ? `bytes that are ${describe(bytes)}` : describe(texture),
      )
    job.setBytes(arrays.bytes, bytes)
    job.setText(arrays.mimeType, mimeTypeKind.read(mimeType, part(`${name}.mimeType`)))
  }
}

/** Copies the job's mesh into new arrays. */
export function takeMesh(job: Job): Mesh {
  const mesh: Mesh = { positions: job.floats('positions'), normals: job.floats('normals') }
  for (const name of ['uvs', 'colors', 'tangents'] as const) {
    const numbers = job.floats(name)
    if (numbers.length) mesh[name] = numbers
  }
  const indices = job.indices()
  if (indices.length) mesh.indices = indices
  const baseColor = job.baseColor()
  if (baseColor) mesh.material = { baseColor }
  for (const { name, arrays } of textures) {
    const bytes = job.bytes(arrays.bytes)
    if (mesh.material && bytes.length)
      mesh.material[name] = { bytes, mimeType: job.text(arrays.mimeType) }
  }
  return mesh
}

/** Returns the mesh with the vertices of each triangle in reverse order; the vertices themselves stay the same. */
export function reverseTriangles(mesh: Mesh): Mesh {
  const { positions, indices } = mesh
  const reversed =
    indices?.slice() ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i)
  for (let i = 2; i < reversed.length; i += 3) {
    const second = reversed[i - 1]!
    reversed[i - 1] = reversed[i]!
    reversed[i] = second
  }
  return { ...mesh, indices: reversed }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null
