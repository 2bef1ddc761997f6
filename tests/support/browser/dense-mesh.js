// Vertices to warp, as the float32 inputs of a vertex shader: position, normal, uv, color, and the gradients of the normal over
// the surface.
import { normalGradients } from '../../warps/normal-field.js'
import { directions } from './mesh.js'

export const layout = {
  position: 3,
  normal: 3,
  uv: 2,
  color: 4,
  normalXGradient: 3,
  normalYGradient: 3,
  normalZGradient: 3,
}
export const stride = Object.values(layout).reduce((sum, size) => sum + size)

const makeSphere = (count) =>
  directions(count).map((point) => ({
    position: point,
    normal: point,
    uv: [(1 + point[0]) / 2, (1 - point[1]) / 2],
  }))

/** Returns the vertices of a cube with faces at ±1, each divided into `cells` × `cells` squares. */
const makeCube = (cells) =>
  [0, 1, 2].flatMap((axis) =>
    [-1, 1].flatMap((side) =>
      Array.from({ length: (cells + 1) ** 2 }, (_, i) => {
        const [u, v] = [(i % (cells + 1)) / cells, Math.floor(i / (cells + 1)) / cells]
        const rotateAxes = (a, b, c) => [0, 1, 2].map((k) => [a, b, c][(k - axis + 3) % 3])
        return {
          position: rotateAxes(side, 2 * u - 1, 2 * v - 1),
          normal: rotateAxes(side, 0, 0),
          uv: [u, v],
        }
      }),
    ),
  )

/** Returns points on the axes and others, each with unusual normals that a loaded model may have. */
function makeUnusualVertices() {
  const scaleTo = (length) => (n) => n.map((x) => length * x)
  const constants = [
    [1, 1e-20, 0],
    [1e-20, 1, 0],
    [0, 0, 0],
    [0, 3, 4],
  ].map((n) => () => n)
  const normals = [...constants, ...[1, 1e-3, 1e-6, 1e3, 1e6].map(scaleTo)]
  const onAxes = [0, 1, 2].flatMap((axis) =>
    [-1, 1].map((side) => [0, 1, 2].map((k) => (k === axis ? side : 0))),
  )
  const points = [...onAxes, ...makeSphere(9).map(({ position }) => position), [0, 0, 0]]
  return points.flatMap((position) =>
    normals.map((normal) => ({ position, normal: normal(position), uv: [0.25, 0.75] })),
  )
}

const colorAt = ([x, y, z]) => [0.5 + 0.4 * x, 0.5 + 0.4 * y, 0.5 - 0.4 * z, 0.6 + 0.3 * x * y]

/** Makes the vertices of a sphere, a cube and special cases, of radius `size`. If `every` is n, keeps only every nth vertex. */
export function denseMesh(size, every = 1) {
  const all = [...makeSphere(1200), ...makeCube(13), ...makeUnusualVertices()]
  const points = all.filter((_, i) => i % every === 0)
  return Float32Array.from(
    points.flatMap(({ position, normal, uv }) => [
      ...position.map((x) => size * x),
      ...normal,
      ...uv,
      ...colorAt(position),
      ...Object.values(normalGradients(normal, size)).flat(),
    ]),
  )
}

/** Returns a vertex of a mesh as an object, with exactly the numbers that the shader reads. */
export function vertexAt(mesh, i) {
  let start = i * stride
  const read = (size) => Array.from(mesh.subarray(start, (start += size)))
  return Object.fromEntries(Object.entries(layout).map(([name, size]) => [name, read(size)]))
}

/** Returns all vertices as objects. */
export const vertices = (mesh) =>
  Array.from({ length: mesh.length / stride }, (_, i) => vertexAt(mesh, i))

/** Returns one attribute of all vertices. */
function readAttribute(mesh, name) {
  const names = Object.keys(layout)
  const first = names.slice(0, names.indexOf(name)).reduce((sum, each) => sum + layout[each], 0)
  const size = layout[name]
  const all = new Float32Array((mesh.length / stride) * size)
  for (let i = 0; i < all.length; i++)
    all[i] = mesh[Math.floor(i / size) * stride + first + (i % size)]
  return all
}

/**
 * Returns a mesh in the form that `evaluate` takes, with those gradients of the normal that are in `attributes`, the attributes that the
 * warp's shader reads.
 */
export function arraysOf(mesh, attributes) {
  const all = (name) => readAttribute(mesh, name)
  const gradients = attributes
    .filter(({ name }) => name.endsWith('Gradient'))
    .map(({ name }) => [`${name}s`, all(name)])
  return {
    positions: all('position'),
    normals: all('normal'),
    uvs: all('uv'),
    colors: all('color'),
    ...Object.fromEntries(gradients),
  }
}

/** Returns positions and normals, six numbers per vertex, like the results of the shaders. */
export function interleave({ positions, normals }) {
  const results = new Float32Array(2 * positions.length)
  for (let i = 0; i < positions.length; i += 3) {
    results.set(positions.subarray(i, i + 3), 2 * i)
    results.set(normals.subarray(i, i + 3), 2 * i + 3)
  }
  return results
}
