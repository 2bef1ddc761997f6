// `loadMesh`: reads a model file as a mesh.
import { isGeometry } from '../core/inputs/geometry.js'
import { callable, kind, optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object } from '../options/schema.js'
import { decodersKind, findDecoder, type Codec, type Decoders } from './decoders.js'
import { geometryAs } from './geometry.js'
import { withJob, type Job } from './job.js'
import { takeMesh, type Mesh } from './mesh-arrays.js'
import {
  locate,
  readBytes,
  resolveBeside,
  type Bytes,
  type Resolve,
  type Source,
} from './sources.js'
import { unpackParts, type FoundDecoders } from './unpack.js'

export interface LoadOptions {
  /** Loads the files that a .gltf, .obj or .mtl refers to. Default: loads files in the model's folder, if the model has a URL. */
  resolve?: Resolve
  /** Decoders for compressed glTF files. Default: those of the packages meshoptimizer and draco3dgltf, if they are installed. */
  decoders?: Decoders
}

export interface LoadAsOptions<Geometry> extends LoadOptions {
  /** The class `BufferGeometry` of three.js: the result is then such a geometry, with material and warnings in `userData`. */
  as: new () => Geometry
}

const place = new Place('loadMesh')

type MeshClass = new () => unknown

const loadOptions = object({
  resolve: optional(callable<Resolve>('a function from a URI to bytes')),
  as: optional(
    kind<MeshClass>(
      'the class BufferGeometry of three.js',
      (as) => typeof as === 'function' && isGeometry(new (as as MeshClass)()),
    ),
  ),
  decoders: decodersKind,
} satisfies Record<keyof LoadAsOptions<unknown>, unknown>)

/** Maps URIs in the model → the bytes of these files. */
type ReferencedFiles = Map<string, Uint8Array>

/**
 * Reads a model: .glb and .gltf (2.0), .obj with its .mtl, and .stl. All triangles of the model's scene become one mesh, with the
 * transforms of nodes, instances and bones and the weights of morph targets applied. Missing normals are computed, existing
 * ones scaled to length 1, and colours clamped to 0 to 1 (in an .obj, whole numbers up to 255 are scaled). `warnings` lists
 * corrections, and parts that are left out, such as animations. `source` is bytes, a Blob or File, or a URL, which in Node may be a
 * path. Throws a `WarpError` for a file that cannot be read, or is broken or too large.
 */
export function loadMesh<Geometry extends { readonly isBufferGeometry: true }>(
  source: Source,
  options: LoadAsOptions<Geometry>,
): Promise<Geometry>
export function loadMesh(source: Source, options?: LoadOptions): Promise<Mesh>
export async function loadMesh(
  source: Source,
  options?: LoadOptions & { as?: MeshClass },
): Promise<unknown> {
  const { as, resolve, decoders } = loadOptions.read(options, place)
  const { mesh } = await readModel(source, { resolve, decoders: decoders as Decoders })
  return as ? geometryAs(as, mesh) : mesh
}

export interface LoadedModel {
  mesh: Mesh
  /** 1 for each vertex that a material of an .obj colours, otherwise 0. Empty if no vertex is coloured so. */
  painted: Uint8Array
}

/** The model, or what must be fetched before the next try: files, or decoders. */
type Step =
  | { model: LoadedModel; missing?: undefined; neededCodecs?: undefined }
  | { missing: string[]; neededCodecs?: undefined; model?: undefined }
  | { neededCodecs: Codec[]; missing?: undefined; model?: undefined }

/** Reads a model, with options that are already checked. */
export async function readModel(
  source: unknown,
  {
    resolve: chosenResolve,
    decoders,
  }: { resolve?: Resolve | undefined; decoders?: Decoders | undefined },
): Promise<LoadedModel> {
  const located = await locate(source, place)
  const bytes = await readBytes(located, place)
  const resolve =
    chosenResolve ??
    (located instanceof URL ? resolveBeside(located, place, !isGltf(bytes)) : undefined)

  const files: ReferencedFiles = new Map()
  const requested = new Set<string>()
  const foundDecoders: FoundDecoders = new Map()
  for (;;) {
    const step = withJob(place, (job): Step => {
      putFiles(job, bytes, files)
      const missing = job.act('findFiles').filter((uri) => !requested.has(uri))
      if (missing.length && resolve) return { missing }
      const neededCodecs = unpackParts(job, foundDecoders)
      return neededCodecs.length ? { neededCodecs } : { model: load(job) }
    })
    if (step.model) return step.model
    for (const uri of step.missing ?? []) requested.add(uri)
    if (step.missing) await fetchFiles(step.missing, resolve!, files)
    for (const codec of step.neededCodecs ?? [])
      foundDecoders.set(codec, await findDecoder(place, codec, decoders))
  }
}

/** Returns whether a file is a glTF, which needs the files that it refers to, whereas an .obj works without its materials. */
function isGltf(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 64)).trimStart()
  return start.startsWith('glTF') || start.startsWith('{')
}

function putFiles(job: Job, bytes: Uint8Array, files: ReferencedFiles) {
  job.setBytes('file', bytes)
  for (const [name, contents] of files) job.addFile(name, contents)
}

function load(job: Job): LoadedModel {
  const warnings = job.act('loadFile')
  const mesh = takeMesh(job)
  return { mesh: warnings.length ? { ...mesh, warnings } : mesh, painted: job.bytes('painted') }
}

/** Adds to `files` those that exist. The loader in C++ reports missing ones. */
async function fetchFiles(uris: readonly string[], resolve: Resolve, files: ReferencedFiles) {
  for (const uri of uris) {
    const contents: Bytes | undefined = await resolve(uri)
    if (contents !== undefined)
      files.set(uri, await readBytes(contents, new Place(`loadMesh: resolve("${uri}")`)))
  }
}
