// `exportGLB`: from a mesh to a file.
import { WarpError } from '../errors/errors.js'
import { type MeshOrGeometry, putMesh } from './mesh-arrays.js'
import { withJob } from '../wasm/mesh.js'

/**
 * The bytes of a GLB file (glTF 2.0), which other programs open. Normals and tangents get length 1, as the format
 * demands; where a warp left no normal, that of the triangles around is written. Colors are kept between 0 and 1. A
 * texture needs uvs, and tangents need normals, or they are left out. 10 million triangles take some seconds. Throws a
 * `WarpError` for a mesh without triangles, one that is too large for the memory of the module (such as 40 million
 * triangles), arrays that do not fit together, and a texture that is neither PNG nor JPEG.
 */
export function exportGLB(mesh: MeshOrGeometry): Uint8Array {
  return withJob('exportGLB', (job) => {
    putMesh(job, mesh)
    if (job.triangleCount() === 0)
      throw new WarpError('exportGLB: the mesh has no triangles, and a GLB file needs one.')
    job.act('writeFile')
    return job.bytes('file')
  })
}
