// A rasterizer in double: the rest place of the surface at each pixel of a picture, from the corners of its triangles.

/**
 * Returns { pixel, face, values } for each pixel that a triangle covers. `corners` are the vertices on screen, [x, y, depth, w] with the
 * smaller depth in front, and `values` their arrays of numbers, which are interpolated as a GPU does; `w` is 1 without perspective.
 */
export function restPlaces({ corners, values, faces }, width, height) {
  const nearest = new Float64Array(width * height).fill(Infinity)
  const found = new Map()
  for (const face of faces) {
    const [a, b, c] = face.map((i) => corners[i])
    const area = edge(a, b, c)
    if (Math.abs(area) < 1e-9) continue
    const [left, right] = range([a[0], b[0], c[0]], width)
    const [top, bottom] = range([a[1], b[1], c[1]], height)
    for (let y = top; y < bottom; y++)
      for (let x = left; x < right; x++) {
        const point = [x + 0.5, y + 0.5]
        const shares = [
          edge(b, c, point) / area,
          edge(c, a, point) / area,
          edge(a, b, point) / area,
        ]
        if (Math.min(...shares) < 0) continue
        const depth = mix(shares, [a[2], b[2], c[2]])
        const pixel = y * width + x
        if (depth >= nearest[pixel]) continue
        nearest[pixel] = depth
        found.set(pixel, { face, shares: withPerspective(shares, [a, b, c]) })
      }
  }
  return Array.from(found, ([pixel, { face, shares }]) => ({
    pixel,
    face,
    values: mixValues(
      shares,
      face.map((i) => values[i]),
    ),
  }))
}

/** Interpolates lists of numbers between the corners of a triangle. */
export const mixValues = (shares, lists) =>
  lists[0].map((_, k) =>
    mix(
      shares,
      lists.map((list) => list[k]),
    ),
  )

const edge = (a, b, p) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
const mix = (shares, numbers) => numbers.reduce((sum, number, i) => sum + shares[i] * number, 0)
const range = (ends, size) => [
  Math.max(0, Math.floor(Math.min(...ends))),
  Math.min(size, Math.ceil(Math.max(...ends))),
]

function withPerspective(shares, corners) {
  const parts = shares.map((share, i) => share / (corners[i][3] ?? 1))
  const sum = parts[0] + parts[1] + parts[2]
  return parts.map((part) => part / sum)
}
