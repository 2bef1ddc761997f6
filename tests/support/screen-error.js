// Measures how far drawn triangles are from the warped surface on the screen, independently of how the mesh was subdivided.

/** Points inside of a triangle and on its sides, as weights of the corners: the lattice of quarters without the corners, and the middle. */
const lattice = [[1 / 3, 1 / 3, 1 / 3]]
for (let i = 0; i <= 4; i++)
  for (let j = 0; i + j <= 4; j++)
    if (Math.max(i, j, 4 - i - j) < 4) lattice.push([1 - (i + j) / 4, i / 4, j / 4])

/** Interpolates positions and unit normals at places of triangles, given as weights of their corners. */
export function samplesOf({ positions, normals, indices }, triangles, places) {
  const count = 3 * triangles.length * places.length
  const samples = { positions: new Float32Array(count), normals: new Float32Array(count) }
  let at = 0
  for (const t of triangles)
    for (const weights of places) {
      let square = 0
      for (let k = 0; k < 3; k++) {
        const mix = (from) =>
          weights.reduce((sum, w, i) => sum + w * from[3 * indices[3 * t + i] + k], 0)
        samples.positions[at + k] = mix(positions)
        square += (samples.normals[at + k] = mix(normals)) ** 2
      }
      for (let k = 0; k < 3; k++) samples.normals[at + k] /= Math.sqrt(square)
      at += 3
    }
  return samples
}

/**
 * Returns the distances, in pixels, between points of the drawn triangles and the warped points at which they should be.
 * Points outside of the picture are left out. `warpPositions` maps { positions, normals } → warped positions; `view` is
 * { matrix, width, height }, as for `createDetail`; `triangles` are the indices of the triangles to measure.
 */
export function screenErrors(mesh, warpPositions, view, triangles) {
  const { positions, normals, indices } = mesh
  const samples = samplesOf(mesh, triangles, lattice)
  const corners = warpPositions({ positions, normals })
  const truth = warpPositions(samples)
  const errors = []
  const flat = [0, 0, 0]
  let at = 0
  for (const t of triangles)
    for (const weights of lattice) {
      for (let k = 0; k < 3; k++)
        flat[k] = weights.reduce((sum, w, i) => sum + w * corners[3 * indices[3 * t + i] + k], 0)
      const [a, b] = [pixelsOf(truth, at, view), pixelsOf(flat, 0, view)]
      at += 3
      if (a && b) errors.push(Math.hypot(a[0] - b[0], a[1] - b[1]))
    }
  return errors
}

/**
 * Returns the distances, in pixels, between drawn and warped surface at random points, of which about as many are in equal areas of the
 * mesh. `warpPoint` maps [x, y, z] → the warped point. Only the points are measured for which `isMeasured([x, y, z])` is true.
 */
export function randomScreenErrors(mesh, warpPoint, view, random, count, isMeasured) {
  const { positions, indices } = mesh
  const corner = (i) => Array.from(positions.subarray(3 * indices[i], 3 * indices[i] + 3))
  const errors = []
  let total = 0
  const ends = Array.from({ length: indices.length / 3 }, (_, t) => {
    const [a, b, c] = [corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)]
    const [u, v] = [b.map((x, k) => x - a[k]), c.map((x, k) => x - a[k])]
    total += Math.hypot(
      ...[0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]),
    )
    return total
  })
  for (let i = 0, t = 0; i < count; i++) {
    // The points are in the order of the triangles.
    const at = ((i + random()) / count) * total
    while (ends[t] < at && t < ends.length - 1) t++
    const [u, v] = [random(), random()]
    const [w1, w2] = u + v > 1 ? [1 - u, 1 - v] : [u, v]
    const corners = [corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)]
    const mix = ([a, b, c]) => a.map((x, k) => x * (1 - w1 - w2) + b[k] * w1 + c[k] * w2)
    const point = mix(corners)
    if (!isMeasured(point)) continue
    const [drawn, truth] = [mix(corners.map(warpPoint)), warpPoint(point)].map((each) =>
      pixelsOf(each, 0, view),
    )
    if (drawn && truth) errors.push(Math.hypot(drawn[0] - truth[0], drawn[1] - truth[1]))
  }
  return errors
}

/**
 * Returns the position on the screen, in pixels from the middle of the picture, of the point whose coordinates start at `numbers[at]`;
 * `undefined` if it is outside of the picture.
 */
export function pixelsOf(numbers, at, { matrix: m, width, height }) {
  const row = (i) =>
    m[i] * numbers[at] + m[i + 4] * numbers[at + 1] + m[i + 8] * numbers[at + 2] + m[i + 12]
  const w = row(3)
  if (w <= 0 || Math.abs(row(0)) > w || Math.abs(row(1)) > w || Math.abs(row(2)) > w) return
  return [((row(0) / w) * width) / 2, ((row(1) / w) * height) / 2]
}

/** Returns a quantile, such as 0.5 for the median; 0 if there are no numbers. */
export function quantile(numbers, share) {
  const sorted = Float64Array.from(numbers).sort()
  return sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))] ?? 0
}

/** Splits every triangle of a mesh into `n` × `n`. */
export function splitUniformly({ positions, normals, indices }, n) {
  const split = { positions: [], normals: [], indices: [] }
  for (let t = 0; t < indices.length; t += 3) {
    const first = split.positions.length / 3
    const vertexAt = (i, j) => first + i * (n + 1) - (i * (i - 1)) / 2 + j
    for (let i = 0; i <= n; i++)
      for (let j = 0; i + j <= n; j++) {
        const weights = [(n - i - j) / n, i / n, j / n]
        const mix = (from) =>
          [0, 1, 2].map((k) => weights.reduce((s, w, c) => s + w * from[3 * indices[t + c] + k], 0))
        split.positions.push(...mix(positions))
        const normal = mix(normals)
        const length = Math.hypot(...normal)
        split.normals.push(...normal.map((x) => x / length))
      }
    for (let i = 0; i < n; i++)
      for (let j = 0; i + j < n; j++) {
        split.indices.push(vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i, j + 1))
        if (i + j < n - 1)
          split.indices.push(vertexAt(i + 1, j), vertexAt(i + 1, j + 1), vertexAt(i, j + 1))
      }
  }
  return {
    positions: Float32Array.from(split.positions),
    normals: Float32Array.from(split.normals),
    indices: Uint32Array.from(split.indices),
  }
}
