// Assigns the texels of a normal map to triangles.
import { barycentric, type UvTriangles } from './uv-triangles.js'

export interface Cover {
  /** The index of each texel's triangle, row by row; -1 for none. */
  owners: Int32Array
  /** The number of texels whose centre is in a triangle. */
  covered: number
  /** The number of texels whose centre is in several triangles. */
  overlapping: number
}

/**
 * The distance from a triangle, in texels, up to which texels belong to it although their centre is outside: bilinear filtering at a
 * point of the triangle reads texels up to the square root of 2 away.
 */
const margin = 1.5

/** The min depth, in texels, of a point inside of two triangles that counts as an overlap: more than the rounding of uvs. */
const minOverlap = 0.01

/** Assigns each texel whose centre is in a triangle to this triangle, and others nearby to the nearest triangle. */
export function coverTexels(triangles: UvTriangles): Cover {
  const { size, count } = triangles
  const owners = new Int32Array(size * size).fill(-1)
  /** The distance of each texel from its triangle, in texels; negative inside. */
  const distances = new Float32Array(size * size).fill(margin)
  const overlaps = new Uint8Array(size * size)
  const forms = new Float64Array(9)
  for (let triangle = 0; triangle < count; triangle++) {
    if (!triangles.findBarycentricForms(triangle, forms)) continue
    const [left, right] = triangles.range(triangle, 0)
    const [top, bottom] = triangles.range(triangle, 1)
    const heights = [0, 1, 2].map((k) => 1 / Math.hypot(forms[3 * k + 1]!, forms[3 * k + 2]!))
    for (let y = Math.ceil(top - margin); y <= bottom + margin; y++)
      for (let x = Math.ceil(left - margin); x <= right + margin; x++) {
        const texel = size * modulo(y, size) + modulo(x, size)
        const distance = -Math.min(
          barycentric(forms, 0, x, y) * heights[0]!,
          barycentric(forms, 1, x, y) * heights[1]!,
          barycentric(forms, 2, x, y) * heights[2]!,
        )
        const previous = distances[texel]!
        if (distance < -minOverlap && previous < -minOverlap) overlaps[texel] = 1
        if (distance >= previous) continue
        distances[texel] = distance
        owners[texel] = triangle
      }
  }
  return {
    owners,
    covered: distances.reduce((count, distance) => count + (distance <= 0 ? 1 : 0), 0),
    overlapping: overlaps.reduce((count, overlaps) => count + overlaps, 0),
  }
}

const modulo = (x: number, size: number) => ((x % size) + size) % size
