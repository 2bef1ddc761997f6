// `exportGLB`: writes a mesh as a GLB file.
import { Place } from '../options/place.js'
import { withJob } from './job.js'
import { putMesh, type MeshOrGeometry } from './mesh-arrays.js'

const place = new Place('exportGLB')

/**
 * Returns the bytes of a GLB file (glTF 2.0), which other programs can open. Normals and tangents are normalized, as the
 * format requires; normals of length 0 after a warp are replaced by those of the surrounding triangles. Colors are clamped
 * to 0 to 1. A texture without uvs is left out, and so are tangents without normals. 10 million triangles take some seconds.
 * Throws a `WarpError` for a mesh without triangles, one that is too large for the memory of the module (such as 40 million
 * triangles), arrays that do not fit together, and a texture that is neither PNG nor JPEG.
 */
export function exportGLB(mesh: MeshOrGeometry): Uint8Array {
  return withJob(place, (job) => {
    putMesh(job, mesh)
    if (job.triangleCount() === 0)
      throw place.error('the mesh has no triangles, but a GLB file needs at least one.')
    job.act('writeFile')
    return job.bytes('file')
  })
}
