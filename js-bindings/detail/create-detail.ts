// `createDetail`: a mesh that is divided for the screen, for any renderer.
import { hostWarp, type CompiledWarp } from '../compile/compile-warp.js'
import { arrayNames } from '../core/inputs/vertices.js'
import { missingInput } from '../cpu/warp-program.js'
import { describe } from '../errors/errors.js'
import { didYouMean } from '../errors/nearest.js'
import { isList } from '../options/guards.js'
import { boolean, kind } from '../options/kinds.js'
import { describeNumber, finiteFloat, firstWrong } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import type { DetailAttribute } from './detail-base.js'
import { DetailedMesh } from './detailed-mesh.js'
import {
  noUniforms,
  readUpdate,
  updatePlace,
  writeViews,
  type DetailUpdate,
  type DetailView,
} from './update.js'

export type { DetailUpdate, DetailView } from './update.js'

/** A triangle mesh. Its arrays must not change afterwards. */
export interface DetailMesh {
  /** 3 finite numbers per vertex. */
  readonly positions: ArrayLike<number>
  /** 3 numbers per vertex, of length 1. */
  readonly normals?: ArrayLike<number>
  /** 2 numbers per vertex. */
  readonly uvs?: ArrayLike<number>
  /** 4 numbers per vertex: red, green, blue and alpha from 0 to 1. */
  readonly colors?: ArrayLike<number>
  /** 4 numbers per vertex: a direction, and 1 or -1 for the side of the bitangent. */
  readonly tangents?: ArrayLike<number>
  /** 3 indices per triangle, counterclockwise as seen from the front; without indices, every 3 vertices are a triangle. */
  readonly indices?: ArrayLike<number>
}

export interface DetailMeshOptions {
  /**
   * `true` rounds the mesh before it is warped: its triangles become curved ones that meet at the vertices, at right angles to the
   * normals there (PN triangles: Vlachos et al., "Curved PN Triangles", 2001).
   * @default false
   */
  readonly curved?: boolean
}

/** A mesh that is divided as finely as its warped surface needs it on the screen, without cracks. Its vertices are not warped. */
export interface DividedMesh {
  /**
   * Divides the mesh for the views of a frame. Returns `true` if the arrays changed: small changes of the view leave the arrays as they are.
   * Throws a `WarpError` for wrong views, and if a uniform is missing.
   */
  update(views: DetailView | readonly DetailView[], options?: DetailUpdate): boolean
  /** 3 numbers per vertex. All arrays are empty before the first update. They are views, which the next update of any mesh may overwrite: upload or copy them. */
  readonly positions: Float32Array
  /** Unit vectors. Present, like `uvs`, `colors` and `tangents`, if the given mesh has them. */
  readonly normals?: Float32Array
  readonly uvs?: Float32Array
  readonly colors?: Float32Array
  readonly tangents?: Float32Array
  /** 3 indices per triangle. Triangles stay in the order of the given triangles that they are parts of. */
  readonly indices: Uint32Array
  /** Frees the memory of the mesh. A later update starts anew. */
  dispose(): void
}

const place = new Place('createDetail')

const sizes = { normals: 3, uvs: 2, colors: 4, tangents: 4 } as const

const meshArrays = ['positions', ...Object.keys(sizes), 'indices']
/** All properties of a `Mesh` of 'warpjet/mesh' and of the vertices that `evaluate` reads. */
const meshProperties = new Set<string>([
  ...meshArrays,
  ...Object.values(arrayNames),
  'material',
  'warnings',
])
/** Maps names of other libraries → names of this one. */
const synonyms = { vertices: 'positions', index: 'indices', faces: 'indices', triangles: 'indices' }

const meshOptions = object({ curved: boolean(false) } satisfies KindsOf<DetailMeshOptions>)
const isBufferGeometry = (value: unknown) =>
  (value as { isBufferGeometry?: unknown } | undefined)?.isBufferGeometry === true
const meshKind = kind<DetailMesh>(
  'a mesh such as { positions, normals, indices }',
  (value) =>
    typeof value === 'object' && value !== null && !isList(value) && !isBufferGeometry(value),
  {
    advice: (value) =>
      isBufferGeometry(value)
        ? "fromBufferGeometry of 'warpjet/three' makes one of a geometry of three.js"
        : undefined,
  },
)
const listKind = kind<ArrayLike<number>>('a flat array of numbers, such as a Float32Array,', isList)
const warpKind = kind<CompiledWarp>(
  'a result of compileWarp',
  (given) => (given as Partial<CompiledWarp> | undefined)?.[hostWarp] !== undefined,
)

/**
 * Makes a mesh that `update` divides for each frame. Shaders stay as they are: they warp the vertices of the divided mesh like those of
 * the given one. `warp` is a result of `compileWarp`, with or without normals. Throws a `WarpError` if arrays do not fit together, lack
 * what the warp or a curved mesh reads, or if only the GPU can evaluate the warp.
 */
export function createDetail(
  mesh: DetailMesh,
  warp: CompiledWarp,
  options?: DetailMeshOptions,
): DividedMesh {
  const given = meshKind.read(mesh, place.argument(1))
  rejectUnknownArrays(given)
  const { curved: isCurved } = meshOptions.read(options, place)
  const host = warpKind.read(warp, place.argument(2))[hostWarp]
  if (!host.canRunOnCpu)
    throw place.error(
      'this warp calls a function of glsl.fn or reads an image by glsl.texture, which only the GPU can do.',
    )
  const positions = readArray(given.positions, 'positions', 3)
  const vertices = positions.length / 3
  const names = (Object.keys(sizes) as (keyof typeof sizes)[]).filter((name) => given[name])
  const attributes = names.map((name): DetailAttribute => {
    const values = readArray(given[name], name, sizes[name], vertices)
    return { input: name, size: sizes[name], values, isUnit: name === 'normals' }
  })
  const indices = readIndices(given.indices, vertices)
  for (const [input, name] of Object.entries({ normal: 'normals', uv: 'uvs', color: 'colors' }))
    if (host.reads(input as 'uv') && !given[name as 'uvs']) throw missingInput(place, input, name)
  if (isCurved && !given.normals)
    throw place.part('normals').expected('3 numbers per vertex, which a curved mesh needs,', 'none')
  const base = { positions, attributes, indices, isCurved }
  const detailed = new DetailedMesh(host, base, updatePlace)
  const numbers: number[] = []
  const result = {
    update(views: DetailView | readonly DetailView[], options?: DetailUpdate) {
      const { uniforms = noUniforms, tolerance } = readUpdate(options)
      writeViews(numbers, views)
      return detailed.update(uniforms, numbers, tolerance)
    },
    get positions() {
      return detailed.values(-1)
    },
    get indices() {
      return detailed.indices()
    },
    dispose: () => detailed.dispose(),
  }
  names.forEach((name, i) =>
    Object.defineProperty(result, name, { get: () => detailed.values(i), enumerable: true }),
  )
  return result
}

function rejectUnknownArrays(mesh: DetailMesh) {
  for (const name of Object.keys(mesh))
    if (!meshProperties.has(name))
      throw place.error(
        `a mesh has no property "${name}"; ${didYouMean(name, meshArrays, `its arrays are ${meshArrays.join(', ')}.`, synonyms)}`,
      )
}

function readArray(given: unknown, name: string, size: number, vertices?: number) {
  const at = place.part(name)
  const values = listKind.read(given, at)
  const count = vertices === undefined ? `a multiple of ${size}` : `${size * vertices}`
  if (vertices === undefined ? values.length % size !== 0 : values.length !== size * vertices)
    throw at.expected(`${count} numbers, ${size} for each vertex,`, `${values.length}`)
  const wrong = firstWrong(values, finiteFloat)
  if (wrong >= 0)
    throw place.part(`${name}[${wrong}]`).expected('a finite number', describeNumber(values[wrong]))
  return values
}

function readIndices(given: unknown, vertices: number): ArrayLike<number> {
  const indices =
    given === undefined
      ? Uint32Array.from({ length: vertices }, (_, i) => i)
      : listKind.read(given, place.part('indices'))
  if (indices.length % 3 !== 0)
    throw place
      .part(given === undefined ? 'positions' : 'indices')
      .expected('3 vertices for each triangle', `${indices.length} vertices`)
  for (let i = 0; i < indices.length; i++) {
    const index: unknown = indices[i]
    if (!(Number.isInteger(index) && (index as number) >= 0 && (index as number) < vertices))
      throw place
        .part(`indices[${i}]`)
        .expected(`the number of one of ${vertices} vertices, from 0,`, describe(index))
  }
  return indices
}
