// Measures the angles of interpolated and computed normals to the exact normal, at random points of p5's sphere, on the CPU.
import { compileWarp } from '../../../dist/warpjet.js'
import { cross, normalize, subtract } from '../../../tests/support/browser/matrix.js'
import { angleBetween, warpVertex } from '../../../tests/support/browser/oracle.js'
import { pixelWarps } from '../../../tests/support/browser/pixel-normals.js'
import { randomNumbers } from '../../../tests/support/three-meshes.js'
import { say } from '../../lib/terminal.mjs'
import { markdownTable } from '../../reference/parts.mjs'

const pointCount = 20_000
/** The step of the finite differences of `warpVertex`, which computes the exact normals. */
const step = 1e-4

/** Maps the name of a warp in `pixelWarps` → its title in the table. */
const warps = {
  fbm: '`fbm` of 2p, height 0.3',
  simplex: '`simplex` of 2p, height 0.2',
  worley: '`worley` of 2p, height 0.2',
  waves: 'three sines of 7p, height 0.05',
  twist: 'twist 1.5',
}

/** [columns, rows] of the spheres. The first subdivision is p5's default. */
const subdivisions = [
  [24, 16],
  [60, 40],
  [120, 80],
  [240, 160],
]

/** Returns p5's sphere of radius 1, { vertices, faces }. Its normals equal its vertices. */
function createSphere([columns, rows]) {
  const vertices = []
  const faces = []
  for (let row = 0; row <= rows; row++)
    for (let column = 0; column <= columns; column++) {
      const [latitude, longitude] = [Math.PI * (row / rows - 0.5), (2 * Math.PI * column) / columns]
      const [x, z] = [Math.sin(longitude), Math.cos(longitude)]
      vertices.push([Math.cos(latitude) * x, Math.sin(latitude), Math.cos(latitude) * z])
      if (row === rows || column === columns) continue
      const corner = row * (columns + 1) + column
      const below = corner + columns + 1
      faces.push([corner, corner + 1, below], [below, corner + 1, below + 1])
    }
  return { vertices, faces }
}

const interpolate = (weights, vectors) =>
  [0, 1, 2].map((k) => weights.reduce((sum, weight, i) => sum + weight * vectors[i][k], 0))

const areaOf = ([a, b, c]) => Math.hypot(...cross(subtract(b, a), subtract(c, a))) / 2

/** Returns points that are spread evenly over the triangles: [{ face, weights }]. */
function randomPoints({ vertices, faces }) {
  const random = randomNumbers()
  let total = 0
  // Maps each face → the sum of the areas of all faces up to and including it.
  const ends = faces.map((face) => (total += areaOf(face.map((i) => vertices[i]))))
  return Array.from({ length: pointCount }, () => {
    const area = random() * total
    let [first, last] = [0, ends.length - 1]
    while (first < last) {
      const middle = (first + last) >> 1
      if (ends[middle] < area) first = middle + 1
      else last = middle
    }
    const [root, fraction] = [Math.sqrt(random()), random()]
    return { face: faces[first], weights: [1 - root, root * (1 - fraction), root * fraction] }
  })
}

/**
 * Returns the angles to the exact normals in degrees: `vertex` for normals interpolated from the vertices, `pixel` for normals computed at
 * the points. Leaves out points on kinks, which have no normal.
 */
function compareNormals({ offset, at: evaluateOffset }, mesh) {
  const warp = compileWarp((0, eval)(offset), { surfaceVariation: false })
  const normalsAt = (places) => {
    const positions = new Float32Array(places.flatMap(({ position }) => position))
    const normals = new Float32Array(places.flatMap(({ normal }) => normal))
    const warped = warp.evaluate({ positions, normals }).normals
    return places.map((_, i) => [...warped.subarray(3 * i, 3 * i + 3)])
  }
  const corners = mesh.vertices.map((p) => ({ position: p, normal: normalize(p) }))
  const vertexNormals = normalsAt(corners)
  const points = randomPoints(mesh)
  const places = points.map(({ face, weights }) => {
    const position = interpolate(
      weights,
      face.map((i) => mesh.vertices[i]),
    )
    return { position, normal: normalize(position) }
  })
  const pointNormals = normalsAt(places)
  const angles = { vertex: [], pixel: [] }
  for (const [i, { face, weights }] of points.entries()) {
    const { normal } = warpVertex(evaluateOffset, places[i], {}, step)
    if (!normal) continue
    const interpolated = interpolate(
      weights,
      face.map((corner) => vertexNormals[corner]),
    )
    angles.vertex.push(angleBetween(interpolated, normal))
    angles.pixel.push(angleBetween(pointNormals[i], normal))
  }
  return angles
}

const formatDegrees = (x) => `${Number(x.toPrecision(2))}°`

/** Returns the median and the 99th percentile. */
function summarize(angles) {
  const sorted = angles.toSorted((a, b) => a - b)
  return [0.5, 0.99].map((fraction) => sorted[Math.floor(fraction * (sorted.length - 1))])
}

/**
 * Returns the table, with a row per warp. A cell has the median and the 99th percentile of the angles. Normals at vertices have a column per
 * subdivision; normals at pixels have one column, with the largest median and 99th percentile of all subdivisions.
 */
export function measureAngles() {
  const rows = Object.entries(warps).map(([name, title]) => {
    const measured = subdivisions.map((size) =>
      compareNormals(pixelWarps[name], createSphere(size)),
    )
    const pixel = measured.map((angles) => summarize(angles.pixel))
    const largest = [0, 1].map((k) => Math.max(...pixel.map((each) => each[k])))
    const cells = measured.map((angles) => summarize(angles.vertex))
    say(`${title}: ${measured.map(({ vertex }) => vertex.length).join(', ')} points`)
    return [title, ...[...cells, largest].map((pair) => pair.map(formatDegrees).join(' / '))]
  })
  const heads = subdivisions.map(([columns, rows]) => `\`'vertex'\`, ${columns} × ${rows}`)
  return markdownTable(['warp', ...heads, "`'pixel'`, all four"], rows, true)
}
