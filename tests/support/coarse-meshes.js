// Meshes of some shapes with as few triangles as possible. A warp can bend them only after subdivision.

/** Makes a box from -x to x, -y to y and -z to z, of 12 triangles. */
export function box([x, y, z]) {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
    i & 1 ? x : -x,
    i & 2 ? y : -y,
    i & 4 ? z : -z,
  ])
  const sides = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ]
  return toMesh(
    corners,
    sides.flatMap(([a, b, c, d]) => [
      [a, b, c],
      [a, c, d],
    ]),
  )
}

/** Makes a rectangle in the plane z = 0 from -x to x and -y to y, of 2 triangles. */
export function plane([x, y]) {
  return toMesh(
    [
      [-x, -y, 0],
      [x, -y, 0],
      [x, y, 0],
      [-x, y, 0],
    ],
    [
      [0, 1, 2],
      [0, 2, 3],
    ],
  )
}

/** Makes an icosahedron: 20 equal triangles with corners on a sphere. */
export function icosahedron(radius) {
  const golden = (1 + Math.sqrt(5)) / 2
  const scale = radius / Math.hypot(1, golden)
  const corners = []
  for (const a of [-1, 1])
    for (const b of [-golden, golden]) corners.push([0, a, b], [a, b, 0], [b, 0, a])
  // The edges of the icosahedron have length 2 before it is scaled.
  const areNear = (i, j) =>
    Math.abs(Math.hypot(...corners[i].map((x, k) => x - corners[j][k])) - 2) < 1e-9
  const triangles = []
  for (let a = 0; a < 12; a++)
    for (let b = a + 1; b < 12; b++)
      for (let c = b + 1; c < 12; c++)
        if (areNear(a, b) && areNear(b, c) && areNear(c, a))
          triangles.push(orientOutwards([a, b, c], corners))
  return toMesh(
    corners.map((corner) => corner.map((x) => x * scale)),
    triangles,
  )
}

/** Orders the corners of a triangle so that its front faces outwards. */
function orientOutwards([a, b, c], corners) {
  const [p, q, r] = [corners[a], corners[b], corners[c]]
  const volume =
    p[0] * (q[1] * r[2] - q[2] * r[1]) +
    p[1] * (q[2] * r[0] - q[0] * r[2]) +
    p[2] * (q[0] * r[1] - q[1] * r[0])
  return volume > 0 ? [a, b, c] : [a, c, b]
}

function toMesh(corners, triangles) {
  return {
    positions: Float32Array.from(corners.flat()),
    indices: Uint32Array.from(triangles.flat()),
  }
}
