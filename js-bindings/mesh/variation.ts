// `surfaceVariation`: how normals and uvs vary over a mesh.
import { type MeshInput, putMesh } from './mesh.js'
import { type Job, withJob } from './module.js'

/** Three numbers a vertex each. */
export interface SurfaceVariation {
  /** Of the derivative of the normal, a symmetric matrix (the shape operator), the diagonal xx, yy, zz: on a sphere of
   * radius r that matrix is 1/r across the normal and 0 along it. */
  shapeDiagonals: Float32Array
  /** The rest of it: yz, xz, xy. */
  shapeOffDiagonals: Float32Array
  /** How the first texture coordinate rises along the surface, a unit of length; if the mesh has uvs. */
  uGradients?: Float32Array
  /** The same of the second one. */
  vGradients?: Float32Array
}

/**
 * How normals and uvs vary over a mesh: what a warp that depends on them needs for right normals, as arrays for
 * `evaluate({ ...mesh, ...surfaceVariation(mesh), uniforms })` and as attributes of a shader. `bakeWarp` and `subdivide`
 * find it out by themselves. Missing normals are computed before. It comes from the triangles around each vertex
 * (src/mesh/variation.hpp has the sources), so a finer mesh gives a better one; vertices at one place share it unless a hard
 * edge or a seam of the uvs parts them. Triangles without area add nothing. Throws a `WarpError` if arrays do not fit
 * together or the mesh is too large for the memory of the module.
 */
export const surfaceVariation = (mesh: MeshInput): SurfaceVariation =>
  findVariation('surfaceVariation', mesh)

/** The same for `method`. */
export const findVariation = (method: string, mesh: MeshInput): SurfaceVariation =>
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
export function variationOf(job: Job): SurfaceVariation {
  const [shapeDiagonals, shapeOffDiagonals] = [
    job.floats('shapeDiagonals'),
    job.floats('shapeOffDiagonals'),
  ]
  const uGradients = job.floats('uGradients')
  if (!uGradients.length) return { shapeDiagonals, shapeOffDiagonals }
  return { shapeDiagonals, shapeOffDiagonals, uGradients, vGradients: job.floats('vGradients') }
}
