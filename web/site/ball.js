/** The body that the first page warps. */

/** Corners and triangles of a ball of radius 1: a cube's faces, which have no crowded poles, pushed out. */
export function ball(detail) {
  const side = detail + 1
  const points = new Float32Array(6 * side * side * 3)
  const triangles = new Uint16Array(6 * detail * detail * 6)
  const steps = Float64Array.from({ length: side }, (_, k) =>
    Math.tan((k / detail - 0.5) * (Math.PI / 2)),
  )
  const quad = [0, side, 1, 1, side, side + 1]
  let point = 0
  let corner = 0
  for (let face = 0; face < 6; face++) {
    const towards = face < 3 ? 1 : -1
    const [first, second, third] = [0, 1, 2].map((axis) => (axis + 2 * face) % 3)
    for (let i = 0; i <= detail; i++)
      for (let j = 0; j <= detail; j++) {
        const [u, v] = [steps[i], steps[j]]
        const scale = 1 / Math.sqrt(1 + u * u + v * v)
        points[3 * point + first] = towards * scale
        points[3 * point + second] = u * towards * scale
        points[3 * point + third] = v * scale
        if (i < detail && j < detail) for (const step of quad) triangles[corner++] = point + step
        point++
      }
  }
  return { points, triangles }
}
