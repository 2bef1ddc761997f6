/**
 * The Stanford bunny, from the npm package `bunny` (public domain): closed, with smooth normals,
 * upright and unmirrored in p5.
 */

import data from 'bunny'
import { angleWeightedNormals, createMesh, fit, frontUVs, toScreen } from './mesh.js'
import { interpolatePoints, subdivide } from './subdivide.js'

/**
 * Returns the original 1,839 vertices by default; one step of subdivision gives 7,350 vertices and a
 * rounder back.
 */
export function bunny(steps = 0) {
  let mesh = { points: data.positions, triangles: data.cells }
  if (steps > 0) mesh = interpolatePoints(mesh)
  for (let i = 0; i < steps; i++) mesh = subdivide(mesh)
  const { points, triangles } = mesh
  const normals = angleWeightedNormals(points, triangles)
  return toScreen(fit(createMesh({ points, normals, uvs: frontUVs(points), triangles })))
}
