// The shapes of p5 that normals at pixels are tested on, how they are drawn, and the comparison.
import assert from 'node:assert/strict'
import { subdivide } from '../../../dist/mesh.js'
import { icosahedron } from '../coarse-meshes.js'
import * as m from './matrix.js'
import { anglesOf, exactNormals, pixelWarps } from './pixel-normals.js'

export const size = 160
const radius = 60

/** Vertices and faces of a sphere of 1,280 nearly equal triangles. */
function icosphere() {
  const { positions, indices } = subdivide(icosahedron(1), { levels: 3 })
  const threes = (list) =>
    Array.from({ length: list.length / 3 }, (_, i) => [...list.subarray(3 * i, 3 * i + 3)])
  return { vertices: threes(positions).map(m.normalize), faces: threes(indices) }
}

/** Maps a name → p5 code for the geometry, of about radius 1. */
const shapes = {
  sphere: 'buildGeometry(() => sphere(1))',
  box: 'buildGeometry(() => box(1))',
  plane: 'buildGeometry(() => plane(1, 1))',
  torus: 'buildGeometry(() => torus(1, 0.3))',
  icosahedron: `new p5.Geometry(1, 1, function () {
    const { vertices, faces } = ${JSON.stringify(icosphere())}
    this.gid = 'icosahedron'
    this.vertices = vertices.map((p) => createVector(...p))
    this.vertexNormals = vertices.map((p) => createVector(...p))
    this.uvs = vertices.flatMap(([x, y]) => [0.5 + 0.5 * x, 0.5 + 0.5 * y])
    this.faces = faces
  })`,
}

const namesOfWarps = Object.keys(pixelWarps)

/** Maps a shape → the warps that it is drawn with. */
export const allPairs = Object.fromEntries(Object.keys(shapes).map((name) => [name, namesOfWarps]))

/** The pairs of slower renderers and of old versions: each shape and each warp. */
export const somePairs = {
  sphere: namesOfWarps,
  box: ['fbm', 'waves', 'blob'],
  plane: ['waves', 'flag'],
  torus: ['simplex', 'twist'],
  icosahedron: ['worley'],
}

const turn = m.product(m.rotation(0.5, 1, 2), m.rotation(0.4, 2, 0))

/** The distance of the eye. p5 2.3 draws nothing on WebGPU without perspective. */
const distance = 1000

/** Draws a shape; the code of `setup` makes `geometries` and `eye`. */
export const drawShape = `(shape) => {
  background(0)
  setCamera(eye)
  eye.perspective(2 * atan(${size / 2 / distance}), 1, 100, 5000)
  eye.camera(0, 0, ${distance}, 0, 0, 0, 0, 1, 0)
  noStroke()
  push()
  rotateX(0.5); rotateY(0.4); scale(${radius})
  model(geometries[shape])
  pop()
}`

const toScreen = (p) => {
  const [x, y, z] = m.movePoint(turn, p).map((each) => radius * each)
  const near = distance - z
  // 1 / near is linear on the screen.
  return [...[x, y].map((each) => size / 2 + (distance * each) / near), -1 / near, near]
}

export const geometries = `{ ${Object.entries(shapes).map(([name, code]) => `${name}: ${code}`)} }`

/** Returns a shape as a mesh of `exactNormals`, after it was drawn. */
export const describeShape = `(shape) => {
  const { vertices, vertexNormals, uvs, faces } = geometries[shape]
  const list = (vectors) => vectors.map(({ x, y, z }) => [x, y, z])
  const names = ['normalXGradient', 'normalYGradient', 'normalZGradient', 'uGradient', 'vGradient']
  return { vertices: list(vertices), normals: list(vertexNormals), uvs: [...uvs].flat(), faces,
    gradients: names.map((name) => [...geometries[shape]['warpjet_' + name] ?? []]) }
}`

/** Asserts that 99.9% of the normals shown are within 0.1 degrees, and returns that angle. `restAt` is that of `exactNormals`; `shownAt` is in view space. */
export function checkNormals(warp, shape, mesh, { restAt, shownAt }) {
  const { exact, share } = exactNormals(warp, mesh, { toScreen, restAt, width: size, height: size })
  const inView = exact.map(({ pixel, normal }) => ({ pixel, normal: m.turnNormal(turn, normal) }))
  const { median, max, count } = anglesOf(inView, shownAt)
  assert.ok(count > 500 && share > 0.97, `${shape}: ${count} pixels, ${share} of them compared`)
  assert.ok(max < 0.1, `${shape}: ${max} degrees off at 99.9%, ${median} in the median`)
  return max
}
