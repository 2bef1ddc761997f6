// A warp by waves, its normals from a formula, and the angles between these and the normals that a program reads from a baked map.
import { compileWarp } from 'warpjet'
import { bakeNormalMap, exportGLB } from 'warpjet/mesh'
import { cross, normalize } from './browser/matrix.js'
import { angleBetween } from './browser/oracle.js'
import { grid, sphere } from './meshes.js'
import { blend, readNormalMap, shownNormal, visitTexels } from './normal-map.js'

export const waves = compileWarp(({ glsl, position: p }) =>
  glsl.vec3(p.y().mult(7).sin(), p.z().mult(7).sin(), p.x().mult(7).sin()).mult(0.1),
)

/** Returns the normal of `waves` by the cofactors of its Jacobian, in double precision. */
export function wavedNormal([x, y, z], normal) {
  const slope = (number) => 0.7 * Math.cos(7 * number)
  const columns = [
    [1, 0, slope(x)],
    [slope(y), 1, 0],
    [0, slope(z), 1],
  ]
  const cofactors = [0, 1, 2].map((i) => cross(columns[(i + 1) % 3], columns[(i + 2) % 3]))
  return normalize([0, 1, 2].map((c) => cofactors.reduce((sum, k, i) => sum + k[c] * normal[i], 0)))
}

/**
 * The bound of errors from rounding to 8 bits, in degrees: half a step in each channel, which is sqrt(3) / 255, plus 2% for float32 and the
 * scale of the colour.
 */
export const rounding = 1.02 * (Math.sqrt(3) / 255) * (180 / Math.PI)

export const plainSphere = (columns = 24, rows = 16) => {
  const { positions, normals, uvs, indices } = sphere(columns, rows)
  return { positions, normals, uvs, indices }
}

/** Makes a square from 0 to 1, of a grid with `columns` × `columns` vertices; `uvAt(x, y)` returns the uv of a vertex. */
export function square(uvAt = (x, y) => [x, y], columns = 5) {
  const { positions, ...mesh } = grid(columns, columns)
  const scaled = positions.map((x) => x / (columns - 1))
  const uvs = []
  for (let i = 0; i < scaled.length; i += 3) uvs.push(...uvAt(scaled[i], scaled[i + 1]))
  return { ...mesh, positions: scaled, uvs: Float32Array.from(uvs) }
}

/** Returns the position on the sphere at a uv. */
export const sphereAt = ([u, v]) => {
  const [a, b] = [2 * Math.PI * u, Math.PI * v]
  return [Math.sin(b) * Math.cos(a), Math.cos(b), Math.sin(b) * Math.sin(a)]
}
/** Returns the position on the square at a uv. */
export const squareAt = ([x, y]) => [x, y, 0]

/**
 * Returns the max angles, in degrees, between `exact(position, normal)` and two others: the normals of the map (`map`), and interpolated
 * vertex normals (`vertices`); and the number of `texels` that were compared. `restAt` and `normalAt` return the unwarped position and
 * normal at a uv.
 */
export function maxAngles(map, restAt, normalAt, exact, read = shownNormal) {
  const { NORMAL, TEXCOORD_0: uvs } = map
  const vertices = Array.from({ length: uvs.length / 2 }, (_, i) => [
    ...uvs.slice(2 * i, 2 * i + 2),
  ])
  const rest = vertices.flatMap(restAt)
  const normals = vertices.flatMap(normalAt)
  const max = { map: 0, vertices: 0, texels: 0 }
  visitTexels(map, (texel) => {
    const { vertices, weights } = texel
    const expected = exact(
      blend(rest, vertices, weights),
      normalize(blend(normals, vertices, weights)),
    )
    const interpolated = normalize(blend(NORMAL, vertices, weights))
    max.texels++
    max.map = Math.max(max.map, angleBetween(read(map, texel), expected))
    max.vertices = Math.max(max.vertices, angleBetween(interpolated, expected))
  })
  return max
}

/** Bakes `waves` into a normal map, and returns its `maxAngles`. */
export function wavedAngles(mesh, restAt, normalAt) {
  const map = readNormalMap(exportGLB(bakeNormalMap(mesh, waves, { size: 128 })))
  return maxAngles(map, restAt, normalAt, wavedNormal)
}
