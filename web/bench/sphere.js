/** Builds a sphere as a grid of longitudes and latitudes with about `vertices` vertices. Returns { positions, normals, indices }. */
export function sphere(vertices, radius) {
  const rows = Math.round(Math.sqrt(vertices))
  const columns = Math.round(vertices / rows)
  const normals = new Float32Array(rows * columns * 3)
  for (let row = 0, at = 0; row < rows; row++) {
    const latitude = (Math.PI * row) / (rows - 1)
    for (let column = 0; column < columns; column++) {
      const longitude = (2 * Math.PI * column) / (columns - 1)
      normals[at++] = Math.sin(latitude) * Math.cos(longitude)
      normals[at++] = Math.cos(latitude)
      normals[at++] = Math.sin(latitude) * Math.sin(longitude)
    }
  }

  const indices = new Uint32Array((rows - 1) * (columns - 1) * 6)
  for (let row = 0, at = 0; row < rows - 1; row++) {
    for (let column = 0; column < columns - 1; column++) {
      const a = row * columns + column
      const b = a + columns
      indices.set([a, a + 1, b, b, a + 1, b + 1], at)
      at += 6
    }
  }
  return { positions: normals.map((n) => n * radius), normals, indices }
}
