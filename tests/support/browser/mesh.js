// Meshes and directions for tests.

/** Returns `count` unit vectors spread evenly over the sphere: a spiral from pole to pole whose steps are the golden angle. */
export function directions(count) {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count
    const angle = i * Math.PI * (3 - Math.sqrt(5))
    const radius = Math.sqrt(1 - y * y)
    return [radius * Math.cos(angle), y, radius * Math.sin(angle)]
  })
}

/** Returns a sphere of radius 1 → { vertices, normals, uvs, faces }. */
export function sphereMesh(columns, rows) {
  const grid = Array.from({ length: (columns + 1) * (rows + 1) }, (_, i) => [
    (i % (columns + 1)) / columns,
    Math.floor(i / (columns + 1)) / rows,
  ])
  const vertices = grid.map(([u, v]) => {
    const [longitude, latitude] = [2 * Math.PI * u, Math.PI * v]
    const radius = Math.sin(latitude)
    return [radius * Math.sin(longitude), -Math.cos(latitude), radius * Math.cos(longitude)]
  })
  const faces = []
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column
      const c = a + columns + 1
      faces.push([a, a + 1, c], [c, a + 1, c + 1])
    }
  return { vertices, normals: vertices, uvs: grid.flat(), faces }
}

/** Returns the p5 code that makes a p5.Geometry from a mesh. */
export const geometryCode = ({ vertices, normals, uvs, faces }, name) => `
  new p5.Geometry(1, 1, function () {
    const vector = ([x, y, z]) => createVector(x, y, z)
    this.gid = '${name}'
    this.vertices = ${JSON.stringify(vertices)}.map(vector)
    this.vertexNormals = ${JSON.stringify(normals)}.map(vector)
    this.uvs = ${JSON.stringify(uvs)}
    this.faces = ${JSON.stringify(faces)}
  })`
