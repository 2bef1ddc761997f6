// For tests of normals at pixels: p5 shapes, code that draws them, and a comparison with the exact normals.
import assert from 'node:assert/strict'
import { subdivide } from '../../../dist/mesh.js'
import { icosahedron } from '../coarse-meshes.js'
import * as m from './matrix.js'
import { anglesOf, exactNormals, pixelWarps } from './pixel-normals.js'

export const size = 160
const radius = 60

/** Makes vertices and faces of a sphere of 1,280 nearly equal triangles. */
function makeIcosphere() {
  const { positions, indices } = subdivide(icosahedron(1), { levels: 3 })
  const groupByThree = (list) =>
    Array.from({ length: list.length / 3 }, (_, i) => [...list.subarray(3 * i, 3 * i + 3)])
  return { vertices: groupByThree(positions).map(m.normalize), faces: groupByThree(indices) }
}

/** Maps a name → p5 code for the geometry, of about radius 1. */
const shapes = {
  sphere: 'buildGeometry(() => sphere(1))',
  box: 'buildGeometry(() => box(1))',
  plane: 'buildGeometry(() => plane(1, 1))',
  torus: 'buildGeometry(() => torus(1, 0.3))',
  icosahedron: `new p5.Geometry(1, 1, function () {
    const { vertices, faces } = ${JSON.stringify(makeIcosphere())}
    this.gid = 'icosahedron'
    this.vertices = vertices.map((p) => createVector(...p))
    this.vertexNormals = vertices.map((p) => createVector(...p))
    this.uvs = vertices.flatMap(([x, y]) => [0.5 + 0.5 * x, 0.5 + 0.5 * y])
    this.faces = faces
  })`,
}

const warpNames = Object.keys(pixelWarps)

/** Maps a shape → the warps that it is drawn with. */
export const allPairs = Object.fromEntries(Object.keys(shapes).map((name) => [name, warpNames]))

/** Pairs for slower renderers and old versions: each shape at least once, and each warp at least once. */
export const somePairs = {
  sphere: warpNames,
  box: ['fbm', 'waves', 'blob'],
  plane: ['waves', 'flag'],
  torus: ['simplex', 'twist'],
  icosahedron: ['worley'],
}

/** The rotation of the shapes in `drawShape`. */
const turn = m.product(m.rotation(0.5, 1, 2), m.rotation(0.4, 2, 0))

/** The distance of the eye. p5 2.3 draws nothing on WebGPU without perspective. */
const distance = 1000

/** Code that draws a shape. The sketch's `setup` must define `geometries` and the camera `eye`. */
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
  const [x, y, z] = m.transformPoint(turn, p).map((each) => radius * each)
  const depth = distance - z
  // 1 / depth is linear on the screen.
  return [...[x, y].map((each) => size / 2 + (distance * each) / depth), -1 / depth, depth]
}

export const geometries = `{ ${Object.entries(shapes).map(([name, code]) => `${name}: ${code}`)} }`

/** Code that returns a shape, after it has been drawn, as a mesh for `exactNormals`. */
export const describeShape = `(shape) => {
  const { vertices, vertexNormals, uvs, faces } = geometries[shape]
  const list = (vectors) => vectors.map(({ x, y, z }) => [x, y, z])
  const names = ['normalXGradient', 'normalYGradient', 'normalZGradient', 'uGradient', 'vGradient']
  return { vertices: list(vertices), normals: list(vertexNormals), uvs: [...uvs].flat(), faces,
    gradients: names.map((name) => [...geometries[shape]['warpjet_' + name] ?? []]) }
}`

/**
 * Asserts that 99.9% of the drawn normals are off by less than 0.1 degrees; returns the angle that they do not exceed. `restAt` is passed
 * to `exactNormals`; `shownAt` returns the drawn normal of a pixel, in view space.
 */
export function checkNormals(warp, shape, mesh, { restAt, shownAt }) {
  const { exact, share } = exactNormals(warp, mesh, { toScreen, restAt, width: size, height: size })
  const inView = exact.map(({ pixel, normal }) => ({
    pixel,
    normal: m.transformNormal(turn, normal),
  }))
  const { median, max, count } = anglesOf(inView, shownAt)
  assert.ok(
    count > 500 && share > 0.97,
    `${shape}: ${count} pixels compared, ${share} of the sample`,
  )
  assert.ok(max < 0.1, `${shape}: 99.9% are within ${max} degrees, half within ${median}`)
  return max
}
