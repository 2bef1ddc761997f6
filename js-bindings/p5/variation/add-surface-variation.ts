/** `addSurfaceVariation`: stores how a p5.Geometry's normals and uvs vary in vertex properties, which only p5 2.x has. */
import { importMesh } from '#mesh'
import { withOwnErrors } from '../page/own-errors.js'

/** Computes the gradients of normal and uv over a geometry and stores them in it; replaces earlier ones. */
export async function addSurfaceVariation<Geometry>(geometry: Geometry): Promise<Geometry> {
  const { varyGeometry } = await importMesh('addSurfaceVariation')
  await withOwnErrors(() => varyGeometry(geometry))
  return geometry
}
