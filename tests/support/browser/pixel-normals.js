// Warps for tests of normals at pixels in all hosts, and the exact normals of a warped mesh.
import { compileWarp } from '../../../dist/warpjet.js'
import * as noise from '../noise.js'
import { cross, dot, subtract } from './matrix.js'
import { angleBetween, warpVertex } from './oracle.js'
import { mixValues, rasterize } from './rasterize.js'

const { cos, sin } = Math
const scale = (p, factor) => p.map((x) => x * factor)
const along = (height) => (p) => scale(p, height(p))

/**
 * Maps a name → `offset`, the source of an offset function for a mesh of radius 1, and `at`, the same function of numbers. Offsets that
 * read normal or uv have no `at`: their warped normals depend on how these inputs vary over the mesh.
 */
export const pixelWarps = {
  fbm: {
    offset: `({ glsl, position }) => position.mult(glsl.fbm(position.mult(2)).mult(0.3))`,
    at: along((p) => 0.3 * noise.fbm(scale(p, 2))),
  },
  simplex: {
    offset: `({ glsl, position }) => position.mult(glsl.simplex(position.mult(2)).mult(0.2))`,
    at: along((p) => 0.2 * noise.simplex(scale(p, 2))),
  },
  worley: {
    offset: `({ glsl, position }) => position.mult(glsl.worley(position.mult(2)).x().mult(0.2))`,
    at: along((p) => 0.2 * noise.worley(scale(p, 2))[0]),
  },
  waves: {
    offset: `({ glsl, position }) => glsl.vec3(position.y().mult(7).sin(), position.z().mult(7).sin(), position.x().mult(7).sin()).mult(0.05)`,
    at: ([x, y, z]) => scale([sin(7 * y), sin(7 * z), sin(7 * x)], 0.05),
  },
  twist: {
    offset: `({ glsl, position }) => glsl.rotateY(position.y().mult(1.5)).mult(position).sub(position)`,
    at([x, y, z]) {
      const [c, s] = [cos(1.5 * y), sin(1.5 * y)]
      return [c * x + s * z - x, 0, c * z - s * x - z]
    },
  },
  flag: {
    offset: `({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(12).sin().mult(uv.y()).mult(0.05))`,
  },
  blob: {
    offset: `({ normal, position }) => normal.mult(position.x().mult(5).sin().add(position.y().mult(4).cos()).mult(0.06))`,
  },
}

const names = ['normalXGradient', 'normalYGradient', 'normalZGradient', 'uGradient', 'vGradient']
const vectorAt = (numbers, start) => numbers.slice(start, start + 3)

/**
 * Returns { share, exact }; `exact` lists { pixel, normal }, the exact outward normal in the mesh's own space, for about `count` of the
 * pixels that the warped mesh covers. A mesh has `vertices`, `normals`, `uvs`, `faces` and, for offsets of normal or uv, `gradients`.
 * `toScreen` maps a warped position to [x, y, depth, w]. `restAt` returns position, normal and uv at a pixel as the GPU interpolated them,
 * nine numbers, since GPUs snap vertices to fractions of a pixel; pixels at silhouettes, where the interpolated values of the GPU differ
 * much from ours, are left out. `share` is the fraction of the pixels that remain.
 */
export function exactNormals(name, mesh, { toScreen, restAt, width, height, count = 1200 }) {
  const { offset, at } = pixelWarps[name]
  const { vertices, normals, uvs, faces, gradients = names.map(() => []) } = mesh
  // Pages get the same source.
  const warp = compileWarp((0, eval)(offset), { surfaceVariation: true })
  const values = vertices.map((p, i) => [
    ...p,
    ...normals[i],
    uvs[2 * i] ?? 0,
    uvs[2 * i + 1] ?? 0,
    ...gradients.flatMap((list) => [0, 1, 2].map((k) => list[3 * i + k] ?? 0)),
  ])
  const moved = warp.evaluate(arraysOf(values)).positions
  const corners = vertices.map((_, i) => toScreen([...moved.subarray(3 * i, 3 * i + 3)]))
  const places = rasterize({ corners, values, faces }, width, height)
  const sample = places.filter((_, i) => i % Math.max(1, Math.floor(places.length / count)) === 0)
  const seen = sample.flatMap(({ pixel, face, values: ours }) => {
    const rest = restAt(pixel)
    const distance = Math.hypot(...vectorAt(rest, 0).map((x, i) => x - ours[i]))
    const length = Math.hypot(...vectorAt(rest, 3))
    for (let k = 3; k < 6; k++) rest[k] /= length
    const weights = barycentric(
      vectorAt(rest, 0),
      face.map((i) => vertices[i]),
    )
    const corners = face.map((i) => values[i])
    const interpolated = weights ? mixValues(weights, corners) : ours
    return distance < 0.05
      ? [{ pixel, values: [...rest.slice(0, 8), ...interpolated.slice(8)] }]
      : []
  })
  const share = seen.length / sample.length
  const exact = at
    ? seen.map((place) => normalByDifferences(at, place))
    : evaluateNormals(warp, seen)
  // At a kink there is no normal.
  return { share, exact: exact.filter(({ normal }) => normal) }
}

/** Returns the barycentric coordinates of a point in the plane of a triangle; `undefined` if the corners are on a line. */
function barycentric(point, [a, b, c]) {
  const [u, v, w] = [b, c, point].map((end) => subtract(end, a))
  const normal = cross(u, v)
  const area = dot(normal, normal)
  if (area < 1e-16) return undefined
  const [second, third] = [dot(cross(w, v), normal) / area, dot(cross(u, w), normal) / area]
  return [1 - second - third, second, third]
}

const arraysOf = (all) => ({
  positions: new Float64Array(all.flatMap((v) => vectorAt(v, 0))),
  normals: new Float64Array(all.flatMap((v) => vectorAt(v, 3))),
  uvs: new Float64Array(all.flatMap((v) => v.slice(6, 8))),
  ...Object.fromEntries(
    names.map((each, k) => [
      `${each}s`,
      new Float64Array(all.flatMap((v) => vectorAt(v, 8 + 3 * k))),
    ]),
  ),
})

function normalByDifferences(at, { pixel, values }) {
  const vertex = { position: vectorAt(values, 0), normal: vectorAt(values, 3) }
  return { pixel, normal: warpVertex(at, vertex, {}, 1e-4).normal }
}

/** Evaluates the warp on the CPU, where other tests compare its normals with finite differences. */
function evaluateNormals(warp, places) {
  const { normals } = warp.evaluate(arraysOf(places.map(({ values }) => values)))
  return places.map(({ pixel }, i) => ({ pixel, normal: [...normals.subarray(3 * i, 3 * i + 3)] }))
}

/**
 * Compares the drawn normals, which `shownAt(pixel)` returns, with the exact ones. Returns { median, max, count }: angles in degrees, where
 * 99.9% of the pixels are within `max`, and the number of pixels.
 */
export function anglesOf(exact, shownAt) {
  const angles = exact.map(({ pixel, normal }) => angleBetween(shownAt(pixel), normal))
  angles.sort((a, b) => a - b)
  const at = (share) => angles[Math.min(angles.length - 1, Math.floor(share * angles.length))]
  return { median: at(0.5), max: at(0.999), count: angles.length }
}
