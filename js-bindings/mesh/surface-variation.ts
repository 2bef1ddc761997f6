// `surfaceVariation`: computes the gradients of normals and uvs over a mesh.
import { variationNames } from '../core/inputs/inputs.js'
import { arrayNames } from '../core/inputs/vertices.js'
import { Place } from '../options/place.js'
import type { FloatArray } from '../wasm/mesh-tables.js'
import { withJob, type Job } from './job.js'
import { putMesh, type MeshOrGeometry } from './mesh-arrays.js'

const place = new Place('surfaceVariation')

/** Gradients along the surface, each with 3 numbers per vertex. */
export interface SurfaceVariation {
  /**
   * Gradients of the normal's x, y and z. On a sphere of radius r, each is the tangential part of the unit vector along x, y or z, divided
   * by r.
   */
  normalXGradients: Float32Array
  normalYGradients: Float32Array
  normalZGradients: Float32Array
  /** Gradients of the texture coordinates, if the mesh has any. */
  uGradients?: Float32Array
  vGradients?: Float32Array
}

/**
 * Computes the gradients of normals and uvs over a mesh. A warp that reads normals or uvs needs them for exact normals: as arrays for
 * `evaluate({ ...mesh, ...surfaceVariation(mesh) }, { uniforms })`, or as attributes of a shader. `bakeWarp` and `subdivide` compute
 * the gradients by themselves. Missing normals are computed first. Gradients are estimated from the triangles around each vertex
 * (src/mesh/surface/variation.hpp has the sources), so a finer mesh gives better ones; vertices at the same position have the same
 * gradients, unless a hard edge or a seam of the uvs separates them. Triangles without area are ignored. Throws a `WarpError` if arrays
 * do not fit together or the mesh is too large for the memory of the module.
 */
export const surfaceVariation = (mesh: MeshOrGeometry): SurfaceVariation =>
  findVariation(place, mesh)

/** Does the same as `surfaceVariation`; error messages name the function of `place`. */
export const findVariation = (place: Place, mesh: MeshOrGeometry): SurfaceVariation =>
  withJob(place, (job) => {
    putMesh(job, mesh)
    job.act('addNormals')
    return takeVariation(job)
  })

/** Computes the gradients of the job's mesh, which must have normals. */
export function takeVariation(job: Job): SurfaceVariation {
  job.act('addVariation')
  return variationOf(job)
}

/** Returns the gradients that the job's mesh has: those of the normal, and of the uvs if it has any. */
export const variationOf = (job: Job) =>
  Object.fromEntries(
    variationNames
      .map((name) => [arrayNames[name], job.floats(arrayNames[name] as FloatArray)] as const)
      .filter(([, numbers], i) => i < 3 || numbers.length),
  ) as unknown as SurfaceVariation
