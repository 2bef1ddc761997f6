// `loadMesh`: from a file to a mesh.
import { WarpError, describe } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
import { isGeometry } from '../core/inputs/geometry.js'
import { geometryAs } from './geometry.js'
import { type Codec, type Decoders, checkDecoders, findDecoder } from './decoders.js'
import { type Mesh, takeMesh } from './mesh-arrays.js'
import { type FoundDecoders, unpackParts } from './unpack.js'
import { type Job, withJob } from '../wasm/mesh.js'
import {
  type Bytes,
  type Resolve,
  type Source,
  locate,
  readBytes,
  resolveBeside,
} from './sources.js'

export interface LoadOptions {
  /** Loads the further files that a .gltf, .obj or .mtl names. Default: those beside the model, if it has a URL. */
  resolve?: Resolve
  /** Decoders for compressed glTF files. Default: those of the packages meshoptimizer and draco3dgltf, if they are installed. */
  decoders?: Decoders
}

export interface LoadAsOptions<Geometry> extends LoadOptions {
  /** `BufferGeometry` of three.js: then the model comes as one, its material and warnings in `userData`. */
  as: new () => Geometry
}

type FurtherFiles = Map<string, Uint8Array>

/**
 * Reads a model: .glb and .gltf (2.0), .obj with its .mtl, and .stl. All triangles of its scene become one mesh, with the
 * transforms of nodes, instances and bones and the weights of morph targets applied. Missing normals are computed, other
 * normals scaled to length 1, and colours clamped to 0 to 1 (in an .obj, whole numbers up to 255 are scaled). `warnings` lists
 * what is left out, such as animations, and what is corrected. `source` is
 * bytes, a Blob or File, or a URL, which in Node may be a path. Throws a `WarpError` for a file that cannot be read, or is broken
 * or too large.
 */
export function loadMesh<Geometry extends { readonly isBufferGeometry: true }>(
  source: Source,
  options: LoadAsOptions<Geometry>,
): Promise<Geometry>
export function loadMesh(source: Source, options?: LoadOptions): Promise<Mesh>
export async function loadMesh(
  source: Source,
  options: LoadOptions & { as?: new () => unknown } = {},
): Promise<unknown> {
  checkOptions('loadMesh', options, ['resolve', 'as', 'decoders'])
  const { as } = options
  if (as === undefined) return (await readModel(source, options)).mesh
  if (typeof as !== 'function' || !isGeometry(new as()))
    throw new WarpError(
      `loadMesh: the option "as" must be the class BufferGeometry of three.js, but is ${describe(as)}.`,
    )
  return geometryAs(as, (await readModel(source, options)).mesh)
}

/** A mesh. `painted` is 1 for each vertex that a material of an .obj gives a colour, otherwise 0; empty if none does. */
export interface LoadedModel {
  mesh: Mesh
  painted: Uint8Array
}

type Step =
  | { model: LoadedModel; missing?: undefined; needed?: undefined }
  | { missing: string[]; needed?: undefined; model?: undefined }
  | { needed: Codec[]; missing?: undefined; model?: undefined }

/** Reads a model, for `method`, which the user called. */
export async function readModel(
  source: unknown,
  { resolve: given, decoders }: LoadOptions,
): Promise<LoadedModel> {
  if (given !== undefined && typeof given !== 'function')
    throw new WarpError(
      `loadMesh: the option "resolve" must be a function from a URI to bytes, but is ${describe(given)}.`,
    )
  checkDecoders('loadMesh', decoders)
  const place = await locate(source, 'loadMesh')
  const bytes = await readBytes(place, 'loadMesh')
  const resolve =
    given ?? (place instanceof URL ? resolveBeside(place, 'loadMesh', !isGltf(bytes)) : undefined)

  const files: FurtherFiles = new Map()
  const asked = new Set<string>()
  const found: FoundDecoders = new Map()
  for (;;) {
    const step = withJob('loadMesh', (job): Step => {
      putFiles(job, bytes, files)
      job.act('findFiles')
      const missing = job.texts().filter((uri) => !asked.has(uri))
      if (missing.length && resolve) return { missing }
      const needed = unpackParts(job, found)
      return needed.length ? { needed } : { model: load(job) }
    })
    if (step.model) return step.model
    for (const uri of step.missing ?? []) asked.add(uri)
    if (step.missing) await gather(step.missing, resolve!, files)
    for (const codec of step.needed ?? [])
      found.set(codec, await findDecoder('loadMesh', codec, decoders))
  }
}

/** Only a .gltf needs files; an .obj can do without its materials. */
function isGltf(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 64)).trimStart()
  return start.startsWith('glTF') || start.startsWith('{')
}

function putFiles(job: Job, bytes: Uint8Array, files: FurtherFiles) {
  job.setBytes('file', bytes)
  for (const [name, contents] of files) {
    job.setText('name', name)
    job.setBytes('contents', contents)
    job.act('keepFile')
  }
}

function load(job: Job): LoadedModel {
  job.act('loadFile')
  const warnings = job.texts()
  const mesh = takeMesh(job)
  return { mesh: warnings.length ? { ...mesh, warnings } : mesh, painted: job.bytes('painted') }
}

/** Adds those of the files that exist. The loader reports the missing ones. */
async function gather(uris: readonly string[], resolve: Resolve, files: FurtherFiles) {
  for (const uri of uris) {
    const contents: Bytes | undefined = await resolve(uri)
    if (contents !== undefined)
      files.set(uri, await readBytes(contents, `loadMesh: resolve("${uri}")`))
  }
}
