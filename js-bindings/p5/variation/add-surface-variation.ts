/** `addSurfaceVariation`: how a p5.Geometry varies, as properties of its vertices, which p5 2.x has. */
import { importMesh } from '#mesh'
import { withOwnErrors } from '../page/own-errors.js'

/** Finds out how a geometry varies, and keeps it there, in place of what was there before. */
export async function addSurfaceVariation<Geometry>(geometry: Geometry): Promise<Geometry> {
  const { varyGeometry } = await importMesh('addSurfaceVariation')
  await withOwnErrors(() => varyGeometry(geometry))
  return geometry
}
