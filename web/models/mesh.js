/**
 * Small tools shared by the gallery's models. A mesh is plain data:
 *
 *   { positions: Float32Array xyz…, normals: Float32Array xyz…,
 *     uvs: Float32Array uv…, indices: Uint32Array abc… }
 *
 * Models are built in a right-handed frame (x right, y up, z towards the viewer) and pass through
 * `toScreen` last, because p5's y axis points down. Nothing here depends on p5 or WebGL.
 */

export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
export const distance = (a, b) =>
  Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2)
export const normalize = (a) => {
  const length = Math.sqrt(dot(a, a))
  return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : [0, 0, 0]
}
export const clamp = (x, low, high) => Math.min(Math.max(x, low), high)
export const mix = (a, b, t) => a + (b - a) * t
export const smoothstep = (a, b, x) => {
  const t = clamp((x - a) / (b - a), 0, 1)
  return t * t * (3 - 2 * t)
}

/**
 * Evaluates the Catmull-Rom curve through knots (lists of equal length) at the fraction f in [0, 1]
 * between knot i and the next.
 */
export function catmullRom(knots, i, f) {
  const [a, b, c, d] = [-1, 0, 1, 2].map((k) => knots[clamp(i + k, 0, knots.length - 1)])
  return b.map((_, k) => {
    const bend = 2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] + f * (3 * b[k] - a[k] - 3 * c[k] + d[k])
    return b[k] + 0.5 * f * (c[k] - a[k] + f * bend)
  })
}

/** Packs lists of `width` numbers each into a typed array. */
function pack(lists, width, type) {
  const result = new type(lists.length * width)
  for (let i = 0; i < lists.length; i++) {
    for (let k = 0; k < width; k++) result[i * width + k] = lists[i][k]
  }
  return result
}

/** Makes a mesh from lists of points; `normals` and `uvs` have one entry per point. */
export function createMesh({ points, normals, uvs, triangles }) {
  return {
    positions: pack(points, 3, Float32Array),
    normals: pack(normals, 3, Float32Array),
    uvs: pack(uvs, 2, Float32Array),
    indices: pack(triangles, 3, Uint32Array),
  }
}

/** Merges several meshes into one. Parts may intersect; nothing is welded. */
export function merge(meshes) {
  const concatenate = (name, type) => {
    const result = new type(meshes.reduce((sum, mesh) => sum + mesh[name].length, 0))
    let offset = 0
    for (const mesh of meshes) {
      result.set(mesh[name], offset)
      offset += mesh[name].length
    }
    return result
  }
  const result = {
    positions: concatenate('positions', Float32Array),
    normals: concatenate('normals', Float32Array),
    uvs: concatenate('uvs', Float32Array),
    indices: concatenate('indices', Uint32Array),
  }
  let vertex = 0
  let index = 0
  for (const mesh of meshes) {
    for (let i = 0; i < mesh.indices.length; i++) result.indices[index++] += vertex
    vertex += mesh.positions.length / 3
  }
  return result
}

/**
 * Returns the normal of each point: the sum of its triangles' normals, each weighted by the triangle's
 * angle at the point (Thürmer and Wüthrich 1998), which does not depend on the triangulation of flat parts.
 */
export function angleWeightedNormals(points, triangles) {
  const sums = points.map(() => [0, 0, 0])
  for (const triangle of triangles) {
    const p = triangle.map((i) => points[i])
    const n = normalize(cross(sub(p[1], p[0]), sub(p[2], p[0])))
    for (let k = 0; k < 3; k++) {
      const a = normalize(sub(p[(k + 1) % 3], p[k]))
      const b = normalize(sub(p[(k + 2) % 3], p[k]))
      const angle = Math.acos(clamp(dot(a, b), -1, 1))
      for (let axis = 0; axis < 3; axis++) sums[triangle[k]][axis] += angle * n[axis]
    }
  }
  return sums.map(normalize)
}

/** Projects texture coordinates from the front: seamless, and upright in p5. */
export function frontUVs(points) {
  const low = [0, 1].map((axis) => points.reduce((m, p) => Math.min(m, p[axis]), Infinity))
  const high = [0, 1].map((axis) => points.reduce((m, p) => Math.max(m, p[axis]), -Infinity))
  return points.map((p) => [
    (p[0] - low[0]) / (high[0] - low[0]),
    (high[1] - p[1]) / (high[1] - low[1]),
  ])
}

/** Moves the center of the bounding box to the origin and scales its longest side to `size`. */
export function fit(mesh, size = 200) {
  const { positions } = mesh
  const low = [Infinity, Infinity, Infinity]
  const high = [-Infinity, -Infinity, -Infinity]
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i])
    high[i % 3] = Math.max(high[i % 3], positions[i])
  }
  const scale = size / Math.max(...sub(high, low))
  for (let i = 0; i < positions.length; i++) {
    positions[i] = (positions[i] - (low[i % 3] + high[i % 3]) / 2) * scale
  }
  return mesh
}

/**
 * Flips y up to y down, so that the model is upright in p5. This is a reflection, not a half turn:
 * p5's screen frame is left-handed, and a half turn would show a mirrored model. A reflection turns
 * triangles inside out, so each one is also reversed, and (b - a) × (c - a) points outwards again.
 */
export function toScreen(mesh) {
  for (let i = 1; i < mesh.positions.length; i += 3) {
    mesh.positions[i] = -mesh.positions[i]
    mesh.normals[i] = -mesh.normals[i]
  }
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const second = mesh.indices[i + 1]
    mesh.indices[i + 1] = mesh.indices[i + 2]
    mesh.indices[i + 2] = second
  }
  return mesh
}
