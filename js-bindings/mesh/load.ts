// `loadMesh`: from a file to a mesh.
import { WarpError, describe } from '../checks/errors.js'
import { checkOptions } from '../checks/options.js'
import { isGeometry } from '../inputs/geometry.js'
import { geometryAs } from './geometry.js'
import { type Mesh, takeMesh } from './mesh-arrays.js'
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
  /** Gives the further files that a .gltf names; where the model has a URL they are taken from beside it. */
  resolve?: Resolve
}

export interface LoadAsOptions<Geometry> extends LoadOptions {
  /** `BufferGeometry` of three.js: then the model comes as one, its material and warnings in `userData`. */
  as: new () => Geometry
}

type FurtherFiles = Map<string, Uint8Array>

/**
 * Reads a model: .glb and .gltf (2.0), and .obj. All triangles of its scene become one mesh, each where its nodes and bones
 * place it; missing normals are computed, colours outside 0 to 1 clamped to it (whole numbers to 255 in an .obj scaled),
 * normals of other lengths scaled to 1; what is left out, such as animations, or put right stands in `warnings`. `source` is
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
  checkOptions('loadMesh', options, ['resolve', 'as'])
  const { as } = options
  if (as === undefined) return read(source, options)
  if (typeof as !== 'function' || !isGeometry(new as()))
    throw new WarpError(
      `loadMesh: the option "as" must be the class BufferGeometry of three.js, but is ${describe(as)}.`,
    )
  return geometryAs(as, await read(source, options))
}

async function read(source: Source, options: LoadOptions): Promise<Mesh> {
  const given: unknown = options.resolve
  if (given !== undefined && typeof given !== 'function')
    throw new WarpError(
      `loadMesh: the option "resolve" must be a function from a URI to bytes, but is ${describe(given)}.`,
    )
  const place = await locate(source, 'loadMesh')
  const bytes = await readBytes(place, 'loadMesh')
  const beside = place instanceof URL ? resolveBeside(place, 'loadMesh') : undefined
  const resolve = options.resolve ?? beside

  const first = withJob('loadMesh', (job) => {
    job.setBytes('file', bytes)
    job.act('findFiles')
    const missing = job.texts()
    return missing.length && resolve ? { missing } : { mesh: load(job) }
  })
  if (first.mesh) return first.mesh
  const files = await gather(first.missing!, resolve!)
  return withJob('loadMesh', (job) => {
    job.setBytes('file', bytes)
    for (const [name, contents] of files) {
      job.setText('name', name)
      job.setBytes('contents', contents)
      job.act('keepFile')
    }
    return load(job)
  })
}

function load(job: Job): Mesh {
  job.act('loadFile')
  const warnings = job.texts()
  return warnings.length ? { ...takeMesh(job), warnings } : takeMesh(job)
}

/** Those of the files that there are; what is missing, the loader says. */
async function gather(uris: readonly string[], resolve: Resolve): Promise<FurtherFiles> {
  const files: FurtherFiles = new Map()
  for (const uri of uris) {
    const contents: Bytes | undefined = await resolve(uri)
    if (contents !== undefined)
      files.set(uri, await readBytes(contents, `loadMesh: resolve("${uri}")`))
  }
  return files
}
