/** The ball that the first page warps. */

/**
 * Builds points and triangles of a ball of radius 1 from the faces of a cube, so that there are no crowded poles. `detail` must be even.
 * The first `coarse` indices in `triangles` are a ball of every second point, the others are a ball of all points.
 */
export function buildBall(detail) {
  const side = detail + 1
  const points = new Float32Array(6 * side * side * 3)
  const coarseIndexCount = 6 * (detail / 2) ** 2 * 6
  const triangles = new Uint16Array(coarseIndexCount + 6 * detail * detail * 6)
  const places = Float64Array.from({ length: side }, (_, k) =>
    Math.tan((k / detail - 0.5) * (Math.PI / 2)),
  )
  let point = 0
  for (let face = 0; face < 6; face++) {
    const towards = face < 3 ? 1 : -1
    const [first, second, third] = [0, 1, 2].map((axis) => (axis + 2 * face) % 3)
    for (const u of places)
      for (const v of places) {
        const scale = 1 / Math.sqrt(1 + u * u + v * v)
        points[point + first] = towards * scale
        points[point + second] = u * towards * scale
        points[point + third] = v * scale
        point += 3
      }
  }
  let corner = 0
  for (const step of [2, 1]) {
    // The diagonals alternate, because ridges that cross parallel diagonals look jagged.
    const quads = [
      [0, side, 1, 1, side, side + 1],
      [0, side, side + 1, 0, side + 1, 1],
    ].map((quad) => quad.map((next) => next * step))
    for (let face = 0; face < 6; face++)
      for (let i = 0; i < detail; i += step)
        for (let j = 0; j < detail; j += step)
          for (const next of quads[((i + j) / step) % 2])
            triangles[corner++] = (face * side + i) * side + j + next
  }
  return { points, triangles, coarse: coarseIndexCount }
}
