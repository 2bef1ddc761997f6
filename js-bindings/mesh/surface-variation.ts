// `surfaceVariation`: how normals and uvs vary over a mesh.
import { variationNames } from '../core/inputs/inputs.js'
import { arrayNames } from '../core/inputs/vertices.js'
import { type MeshOrGeometry, putMesh } from './mesh-arrays.js'
import type { FloatArray } from '../wasm/mesh-tables.js'
import { type Job, withJob } from '../wasm/mesh.js'

/** How fast and which way something rises along the surface: three numbers a vertex each. */
export interface SurfaceVariation {
  /** Of x, y and z of the normal; on a sphere of radius r the part of that axis across the normal, divided by r. */
  normalXGradients: Float32Array
  normalYGradients: Float32Array
  normalZGradients: Float32Array
  /** Of the texture coordinates, if the mesh has some. */
  uGradients?: Float32Array
  vGradients?: Float32Array
}

/**
 * How normals and uvs vary over a mesh: what a warp that depends on them needs for right normals, as arrays for
 * `evaluate({ ...mesh, ...surfaceVariation(mesh) }, { uniforms })` and as attributes of a shader. `bakeWarp` and `subdivide`
 * find it out by themselves. Missing normals are computed before. It comes from the triangles around each vertex
 * (src/mesh/surface/variation.hpp has the sources), so a finer mesh gives a better one; vertices at one place share it unless a hard
 * edge or a seam of the uvs parts them. Triangles without area add nothing. Throws a `WarpError` if arrays do not fit
 * together or the mesh is too large for the memory of the module.
 */
export const surfaceVariation = (mesh: MeshOrGeometry): SurfaceVariation =>
  findVariation('surfaceVariation', mesh)

/** The same for `method`. */
export const findVariation = (method: string, mesh: MeshOrGeometry): SurfaceVariation =>
  withJob(method, (job) => {
    putMesh(job, mesh)
    job.act('addNormals')
    return takeVariation(job)
  })

/** Of the mesh with normals that the job holds. */
export function takeVariation(job: Job): SurfaceVariation {
  job.act('addVariation')
  return variationOf(job)
}

/** What the job's mesh has of it. */
export const variationOf = (job: Job) =>
  Object.fromEntries(
    variationNames
      .map((name) => [arrayNames[name], job.floats(arrayNames[name] as FloatArray)] as const)
      .filter(([, numbers], i) => i < 3 || numbers.length),
  ) as unknown as SurfaceVariation
