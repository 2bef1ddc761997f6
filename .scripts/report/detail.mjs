// Measures how near the triangles of `detail` are to the warped surface, in pixels, and how many there are.
import teapot from 'teapot'
import * as THREE from 'three'
import { createDetail } from '../../dist/detail.js'
import { compileWarp } from '../../dist/warpjet.js'
import { quantile, screenErrors, splitUniformly } from '../../tests/support/screen-error.js'
import { randomNumbers } from '../../tests/support/three-meshes.js'
import { sketchWarps } from '../../tests/warps/sketches.js'
import { say } from '../lib/terminal.mjs'
import { markdownTable } from '../reference/parts.mjs'

const cameras = 200
/** Pictures are square. */
const pixels = 600
/** All triangles are measured for the first 10 cameras of each case, and a random choice of 1,000 for the others. */
const complete = 10
const chosen = 1000
/** The uniform mesh of the same error is searched for 3 cameras of each case, among those of up to 300,000 triangles. */
const compared = 3
const maxUniform = 3e5

/** Half of the size of the meshes, as in each sketch, and the inputs at a moment at which it bends strongly. */
const cases = {
  'airplane-twist': [[100, 34, 98], { millis: 1885 }],
  'bunny-twist': [[100, 100, 100], { millis: 1414 }],
  'coarse-and-fine': [[90, 90, 90], { millis: 1571 }],
  'deformer-melt': [[100, 100, 100], { millis: 1000 }],
  'deformer-noise': [[125, 125, 125], { millis: 1000 }],
  'domain-warping-3d-plain': [[1, 1, 1], { millis: 1000 }],
  fingers: [[128, 200, 42], { millis: 300 }],
  'glsl-waves': [[0.5, 0.5, 0.5], { millis: 1000, choppiness: 0.9 }],
  lotus: [[1, 1, 1], { bend: 1.2 }],
  'sine-cube': [[100, 100, 100], { millis: 500 }],
  'sine-sphere': [[1, 1, 1], { millis: 500 }],
  spoon: [[100, 12.5, 20.6], { millis: 2356 }],
}

function arraysOf(geometry) {
  const { position, normal } = geometry.attributes
  const vertices = Uint32Array.from({ length: position.count }, (_, i) => i)
  const indices = geometry.index?.array ?? vertices
  return { positions: position.array, normals: normal.array, indices }
}

function teapotGeometry() {
  const geometry = new THREE.BufferGeometry()
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(teapot.positions.flat(), 3))
  geometry.setIndex(teapot.cells.flat())
  geometry.center()
  geometry.computeBoundingBox()
  geometry.scale(...Array(3).fill(1 / geometry.boundingBox.max.x))
  geometry.computeVertexNormals()
  return geometry
}

/** From -1 to 1. */
const meshes = {
  box: arraysOf(new THREE.BoxGeometry(1.6, 1.6, 1.6)),
  plane: arraysOf(new THREE.PlaneGeometry(2, 2)),
  sphere: arraysOf(new THREE.SphereGeometry(1, 24, 16)),
  icosahedron: arraysOf(new THREE.IcosahedronGeometry(1, 3)),
  teapot: arraysOf(teapotGeometry()),
}

/** Makes a view of the mesh from a random direction, as near as 2 and as far as 4.6 times its size. */
function randomView(random, size) {
  const camera = new THREE.PerspectiveCamera(60, 1, 0.03 * size, 20 * size)
  const direction = new THREE.Vector3().setFromSphericalCoords(
    1,
    Math.acos(2 * random() - 1),
    2 * Math.PI * random(),
  )
  camera.position.copy(direction.multiplyScalar(size * (2 + 2.6 * random())))
  camera.lookAt(0, 0, 0)
  camera.updateMatrixWorld()
  const matrix = new THREE.Matrix4().multiplyMatrices(
    camera.projectionMatrix,
    camera.matrixWorldInverse,
  )
  return { matrix: matrix.elements, width: pixels, height: pixels }
}

/** Returns the numbers of `max` triangles, or of all if there are no more. */
function chooseTriangles(random, { indices }, max) {
  const count = indices.length / 3
  if (count <= max) return Array.from({ length: count }, (_, i) => i)
  return Array.from({ length: max }, () => Math.floor(random() * count))
}

/** Returns the number of triangles of the coarsest uniform mesh whose error is not larger. */
function uniformTriangles(mesh, warpPositions, view, error, random) {
  const count = mesh.indices.length / 3
  const isFine = (n) => {
    const split = splitUniformly(mesh, n)
    const triangles = chooseTriangles(random, split, 10 * chosen)
    return worstOf(screenErrors(split, warpPositions, view, triangles)) <= error
  }
  let [low, high] = [1, Math.ceil(Math.sqrt(maxUniform / count))]
  while (low < high) {
    const middle = (low + high) >> 1
    if (isFine(middle)) high = middle
    else low = middle + 1
  }
  return count * low * low
}

/** The largest error, but for one of 10,000 points: single points say little. */
const worstOf = (errors) => quantile(errors, 0.9999)

/** Scales a mesh. Its normals stay: they are as good as any others. */
const scale = ({ positions, ...others }, sizes) => ({
  ...others,
  positions: positions.map((x, i) => x * sizes[i % 3]),
})

function measureCase(warp, mesh, sizes, uniforms) {
  const random = randomNumbers(7)
  const size = Math.max(...sizes)
  const scaled = scale(mesh, sizes)
  const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
  const detail = createDetail(scaled, warp)
  const all = []
  const triangles = []
  const ratios = []
  for (let i = 0; i < cameras; i++) {
    const view = randomView(random, size)
    detail.update(view, { uniforms })
    const { positions, normals, indices } = detail
    const divided = {
      positions: positions.slice(),
      normals: normals.slice(),
      indices: indices.slice(),
    }
    const max = i < complete ? Infinity : chosen
    const errors = screenErrors(divided, warpPositions, view, chooseTriangles(random, divided, max))
    for (const error of errors) all.push(error)
    triangles.push(indices.length / 3)
    if (i >= compared) continue
    const uniform = uniformTriangles(scaled, warpPositions, view, worstOf(errors), random)
    ratios.push(divided.indices.length / 3 / uniform)
  }
  detail.dispose()
  return {
    nearly: quantile(all, 0.999),
    max: quantile(all, 1),
    triangles: quantile(triangles, 0.5),
    ratio: quantile(ratios, 0.5),
    ratios,
  }
}

const names = Object.keys(meshes)

export async function measure() {
  const found = {}
  for (const { name, warp } of await sketchWarps()) {
    if (!cases[name]) continue
    const [sizes, uniforms] = cases[name]
    const compiled = compileWarp(warp, { normals: false })
    found[name] = names.map((mesh) => measureCase(compiled, meshes[mesh], sizes, uniforms))
    say(`${name}: ${found[name].map(({ nearly }) => nearly.toFixed(2)).join(' ')}`)
  }
  const all = Object.values(found).flat()
  const ratios = all.flatMap((each) => each.ratios)
  const count = (isTrue) => `${all.filter(isTrue).length} of ${all.length}`
  const table = (key, digits) =>
    markdownTable(
      ['warp', ...names],
      Object.entries(found).map(([name, cells]) => [
        `\`${name}\``,
        ...cells.map((each) => each[key].toFixed(digits)),
      ]),
      true,
    )
  return {
    summary: `99.9% of the points are within a pixel in ${count(({ nearly }) => nearly <= 1)} cases, and all are within 1.5 pixels in ${count(({ max }) => max <= 1.5)}. In the median there are ${quantile(ratios, 0.5).toFixed(2)} times as many triangles as in the uniform mesh of the same error, and at most ${Math.max(...ratios).toFixed(2)} times as many.`,
    'nearly all': table('nearly', 2),
    max: table('max', 2),
    triangles: table('triangles', 0),
    ratios: table('ratio', 2),
  }
}
