// The warps of the gallery, the meshes and the views with which the option `detail` is measured. (It divides the triangles of a mesh as
// finely as the current view requires.)
import teapot from 'teapot'
import * as THREE from 'three'
import { compileWarp } from '../../../dist/warpjet.js'
import { quantile, screenErrors, splitUniformly } from '../../../tests/support/screen-error.js'
import { sketchWarps } from '../../../tests/warps/sketches.js'

/** The width and the height of a picture. */
export const pixels = 600
/** The max number of triangles of a uniform mesh. */
const maxUniformTriangles = 3e5

/** Maps each warp → half of its mesh's size, as in its sketch, and its inputs at a moment at which it bends the mesh strongly. */
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

/**
 * Returns the warps with their cases: [{ name, offset, options, warp, sizes, uniforms }]. `warp` computes no normals; `sizes` are half of the
 * mesh's size along x, y and z.
 */
export async function galleryWarps() {
  const warps = await sketchWarps()
  return warps
    .filter(({ name }) => cases[name])
    .map(({ name, warp: offset, options }) => {
      const [sizes, uniforms] = cases[name]
      return {
        name,
        offset,
        options,
        warp: compileWarp(offset, { normals: false }),
        sizes,
        uniforms,
      }
    })
}

/** Returns the arrays of a geometry of three.js. */
export function arraysOf(geometry) {
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

/** Meshes inside of the cube from -1 to 1. */
export const meshes = {
  box: arraysOf(new THREE.BoxGeometry(1.6, 1.6, 1.6)),
  plane: arraysOf(new THREE.PlaneGeometry(2, 2)),
  sphere: arraysOf(new THREE.SphereGeometry(1, 24, 16)),
  icosahedron: arraysOf(new THREE.IcosahedronGeometry(1, 3)),
  teapot: arraysOf(teapotGeometry()),
}

/** Returns a view of a mesh at the origin, in a square picture. `halfSize` is half of the mesh's largest size along an axis. */
export function viewFrom(cameraPosition, halfSize) {
  const camera = new THREE.PerspectiveCamera(60, 1, 0.03 * halfSize, 20 * halfSize)
  camera.position.copy(cameraPosition)
  camera.lookAt(0, 0, 0)
  camera.updateMatrixWorld()
  const matrix = new THREE.Matrix4().multiplyMatrices(
    camera.projectionMatrix,
    camera.matrixWorldInverse,
  )
  return { matrix: matrix.elements, width: pixels, height: pixels }
}

/** Returns the indices of `max` random triangles, among which may be repetitions, or of all triangles if there are at most `max`. */
export function chooseTriangles(random, { indices }, max) {
  const count = indices.length / 3
  if (count <= max) return Array.from({ length: count }, (_, i) => i)
  return Array.from({ length: max }, () => Math.floor(random() * count))
}

/**
 * Finds the coarsest uniform mesh whose error is at most `error`, and returns into how many pieces it splits each side of the triangles. If
 * no mesh with about `maxUniformTriangles` triangles is fine enough, returns the number of pieces in the finest of them.
 */
export function countUniformPieces(mesh, warpPositions, view, error, random) {
  const isFineEnough = (n) => {
    const split = splitUniformly(mesh, n)
    const triangles = chooseTriangles(random, split, 10_000)
    return robustMax(screenErrors(split, warpPositions, view, triangles)) <= error
  }
  let [low, high] = [1, Math.ceil(Math.sqrt((3 * maxUniformTriangles) / mesh.indices.length))]
  while (low < high) {
    const middle = (low + high) >> 1
    if (isFineEnough(middle)) high = middle
    else low = middle + 1
  }
  return low
}

/** Returns the error that only one of 10,000 points exceeds. The maximum itself depends on single points. */
export const robustMax = (errors) => quantile(errors, 0.9999)

/** Scales the positions of a mesh, but not its normals, on which no figure depends. */
export const scale = ({ positions, ...others }, sizes) => ({
  ...others,
  positions: positions.map((x, i) => x * sizes[i % 3]),
})
