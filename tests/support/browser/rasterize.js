// A rasterizer in double: interpolates values of vertices, such as unwarped positions, at the pixels of a picture.

/**
 * Returns { pixel, face, values } for each pixel that a triangle covers. `corners` are the vertices on screen, [x, y, depth, w], where
 * smaller depths are in front and `w` is 1 without perspective. `values` has a list of numbers per vertex, which are interpolated as a GPU
 * does.
 */
export function rasterize({ corners, values, faces }, width, height) {
  const nearest = new Float64Array(width * height).fill(Infinity)
  const frontmost = new Map()
  for (const face of faces) {
    const [a, b, c] = face.map((i) => corners[i])
    const area = signedArea(a, b, c)
    if (Math.abs(area) < 1e-9) continue
    const [left, right] = range([a[0], b[0], c[0]], width)
    const [top, bottom] = range([a[1], b[1], c[1]], height)
    for (let y = top; y < bottom; y++)
      for (let x = left; x < right; x++) {
        const point = [x + 0.5, y + 0.5]
        const weights = [
          signedArea(b, c, point) / area,
          signedArea(c, a, point) / area,
          signedArea(a, b, point) / area,
        ]
        if (Math.min(...weights) < 0) continue
        const depth = mix(weights, [a[2], b[2], c[2]])
        const pixel = y * width + x
        if (depth >= nearest[pixel]) continue
        nearest[pixel] = depth
        frontmost.set(pixel, { face, weights: withPerspective(weights, [a, b, c]) })
      }
  }
  return Array.from(frontmost, ([pixel, { face, weights }]) => ({
    pixel,
    face,
    values: mixValues(
      weights,
      face.map((i) => values[i]),
    ),
  }))
}

/** Interpolates lists of numbers between the corners of a triangle. */
export const mixValues = (weights, lists) =>
  lists[0].map((_, k) =>
    mix(
      weights,
      lists.map((list) => list[k]),
    ),
  )

/** Returns twice the signed area of a triangle. */
const signedArea = (a, b, p) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
const mix = (weights, numbers) => numbers.reduce((sum, number, i) => sum + weights[i] * number, 0)
const range = (ends, size) => [
  Math.max(0, Math.floor(Math.min(...ends))),
  Math.min(size, Math.ceil(Math.max(...ends))),
]

/** Corrects barycentric weights on screen for the perspective. */
function withPerspective(weights, corners) {
  const parts = weights.map((weight, i) => weight / (corners[i][3] ?? 1))
  const sum = parts[0] + parts[1] + parts[2]
  return parts.map((part) => part / sum)
}
