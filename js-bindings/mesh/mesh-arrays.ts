// What a mesh is here: flat arrays, going in and coming out.
import { WarpError, describe } from '../errors/errors.js'
import { finiteFloat, firstWrong, inWords } from '../options/numbers.js'
import { isList } from '../options/options.js'
import { type Geometry, arraysOf, isGeometry } from '../core/inputs/geometry.js'
import type { FloatArray } from '../wasm/mesh-tables.js'
import type { Job } from '../wasm/mesh.js'

/** A picture as its file has it. */
export interface Picture {
  /** PNG or JPEG. */
  bytes: Uint8Array
  mimeType: string
}

export interface Material {
  /** Linear red, green, blue and alpha from 0 to 1; multiplies the texture. */
  baseColor: number[]
  baseColorTexture?: Picture
}

/** A triangle mesh, as every function here returns it. */
export interface Mesh {
  /** Three numbers a vertex. */
  positions: Float32Array
  /** Three numbers a vertex, of length 1, or 0 where the surface has no direction. */
  normals: Float32Array
  /** Two numbers a vertex, from the picture's top left corner. */
  uvs?: Float32Array
  /** Four numbers a vertex: linear red, green, blue and alpha from 0 to 1. */
  colors?: Float32Array
  /** Four numbers a vertex: a direction, and 1 or -1 for the side of the bitangent, as in glTF. */
  tangents?: Float32Array
  /** Three a triangle; without them, every three vertices are one. */
  indices?: Uint32Array
  material?: Material
  /** What was left out of a file or put right, in sentences. */
  warnings?: string[]
}

/** The same, as every function takes it: arrays of any kind, and normals may be missing. */
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

/** A geometry of three.js as a mesh. */
export type MeshOrGeometry = MeshInput | Geometry

/** What comes in, as a mesh. */
export function meshOf(method: string, given: unknown): unknown {
  if (!isGeometry(given)) return given
  if (given.attributes.position) return arraysOf(given)
  throw new WarpError(`${method}: the geometry has no attribute "position".`)
}

/**
 * Lays the mesh into the job and sees that its arrays fit together; throws a `WarpError` if they do not.
 */
export function putMesh(job: Job, given: unknown) {
  const { method } = job
  const mesh = meshOf(method, given)
  if (!isObject(mesh) || !('positions' in mesh))
    throw new WarpError(
      `${method}: a mesh such as { positions, normals, indices } was expected, but ${describe(given)} came.`,
    )
  for (const name of floatArrays) {
    const numbers = mesh[name]
    if (numbers === undefined && name !== 'positions') continue
    job.setFloats(name, checkNumbers(`${method}: ${name}`, numbers), sizes[name])
  }
  if (mesh.indices !== undefined) job.setIndices(checkIndices(method, mesh.indices))
  if (mesh.material !== undefined) putMaterial(job, mesh.material)
  job.act('checkMesh')
}

function putMaterial(job: Job, material: unknown) {
  const place = `${job.method}: material`
  if (!isObject(material))
    throw new WarpError(
      `${place} must be an object such as { baseColor: [1, 1, 1, 1] }, but is ${describe(material)}.`,
    )
  const { baseColor = [1, 1, 1, 1], baseColorTexture } = material
  const color = checkNumbers(`${place}.baseColor`, baseColor)
  if (color.length !== 4 || firstWrong(color, finiteFloat) >= 0)
    throw new WarpError(
      `${place}.baseColor must be four finite numbers, red, green, blue and alpha, but is [${Array.from(color).slice(0, 5).map(inWords).join(', ')}].`,
    )
  job.setBaseColor(color)
  if (baseColorTexture === undefined) return
  const { bytes, mimeType = '' } = isObject(baseColorTexture) ? baseColorTexture : {}
  if (!(bytes instanceof Uint8Array))
    throw new WarpError(
      `${place}.baseColorTexture must be { bytes, mimeType } with bytes in a Uint8Array, but ${isObject(baseColorTexture) ? `its bytes are ${describe(bytes)}` : `is ${describe(baseColorTexture)}`}.`,
    )
  if (typeof mimeType !== 'string')
    throw new WarpError(
      `${place}.baseColorTexture.mimeType must be a text such as "image/png", but is ${describe(mimeType)}.`,
    )
  job.setBytes('picture', bytes)
  job.setText('mimeType', mimeType)
}

/** The mesh that the job holds, as arrays of its own. */
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
  const picture = job.bytes('picture')
  if (mesh.material && picture.length)
    mesh.material.baseColorTexture = { bytes: picture, mimeType: job.text('mimeType') }
  return mesh
}

/** The mesh with each triangle's vertices in the other order; vertices stay where they are. */
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

/** That they are finite is seen in C++. */
function checkNumbers(place: string, value: unknown): ArrayLike<number> {
  if (isList(value)) return value
  throw new WarpError(
    `${place} must be a flat array of numbers, such as a Float32Array, but is ${describe(value)}.`,
  )
}

function checkIndices(method: string, value: unknown): ArrayLike<number> {
  const numbers = checkNumbers(`${method}: indices`, value)
  if (numbers instanceof Uint32Array || numbers instanceof Uint16Array) return numbers
  for (let i = 0; i < numbers.length; i++) {
    const index: unknown = numbers[i]
    if (!(Number.isInteger(index) && (index as number) >= 0 && (index as number) < 2 ** 32))
      throw new WarpError(
        `${method}: indices[${i}] must be the number of a vertex, counted from 0, but is ${describe(index)}.`,
      )
  }
  return numbers
}
