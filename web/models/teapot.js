/**
 * The Utah teapot, from the npm package `teapot` (public domain), spout along +x, upright in p5.
 * The package has 992 triangles in patches that share no vertices: they are welded first, so that
 * subdivision and normals apply to one surface, and then subdivided to bend smoothly. It is a shell:
 * body, spout and lid stay open where they meet, as in Newell's original.
 */

import data from 'teapot'
import { angleWeightedNormals, createMesh, fit, frontUVs, toScreen } from './mesh.js'
import { interpolatePoints, subdivide, weld } from './subdivide.js'

export function teapot() {
  let mesh = interpolatePoints(weld(data.positions, data.cells))
  for (let i = 0; i < 2; i++) mesh = subdivide(mesh)
  const { points, triangles } = mesh
  const normals = angleWeightedNormals(points, triangles)
  return toScreen(fit(createMesh({ points, normals, uvs: frontUVs(points), triangles })))
}
