// Meshes for tests, each computed from a formula.

/** Makes a sphere of radius 1 with seams like a model's, and with all attributes, including tangents with both signs. */
export function sphere(columns = 12, rows = 8) {
  const mesh = { positions: [], normals: [], uvs: [], colors: [], tangents: [], indices: [] }
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) {
      const [u, v] = [i / columns, j / rows]
      const [a, b] = [2 * Math.PI * u, Math.PI * v]
      const normal = [Math.sin(b) * Math.cos(a), Math.cos(b), Math.sin(b) * Math.sin(a)]
      mesh.positions.push(...normal)
      mesh.normals.push(...normal)
      mesh.uvs.push(u, v)
      mesh.colors.push(u, v, 1 - u, 1)
      mesh.tangents.push(-Math.sin(a), 0, Math.cos(a), i % 2 ? 1 : -1)
    }
  const index = (i, j) => j * (columns + 1) + i
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      if (j > 0) mesh.indices.push(index(i, j), index(i + 1, j), index(i + 1, j + 1))
      if (j < rows - 1) mesh.indices.push(index(i, j), index(i + 1, j + 1), index(i, j + 1))
    }
  return toTypedArrays(mesh)
}

/** Makes a flat grid of `columns` by `rows` vertices in the plane z = 0. */
export function grid(columns, rows) {
  const mesh = { positions: [], normals: [], indices: [] }
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      mesh.positions.push(i, j, 0)
      mesh.normals.push(0, 0, 1)
      if (i === 0 || j === 0) continue
      const [a, b] = [j * columns + i, (j - 1) * columns + i]
      mesh.indices.push(b - 1, b, a, b - 1, a, a - 1)
    }
  return toTypedArrays(mesh)
}

/** Makes one triangle in the plane z = 0. */
export const triangle = () =>
  toTypedArrays({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1] })

export function toTypedArrays({ indices, ...floats }) {
  const mesh = Object.fromEntries(
    Object.entries(floats).map(([name, numbers]) => [name, Float32Array.from(numbers)]),
  )
  return indices ? { ...mesh, indices: Uint32Array.from(indices) } : mesh
}
