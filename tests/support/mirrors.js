// Warps that mirror space, and a geometric check that the outer side of a closed mesh stays outside: the signed volume must be positive,
// which depends on the winding of the triangles, and each vertex normal must point to the front of its triangles.
import assert from 'node:assert/strict'
import { sphere } from './meshes.js'

const vec = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)]
const minus = (a, b) => a.map((x, i) => x - b[i])
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

function* trianglesOf({ positions, indices }) {
  for (let i = 0; i < (indices ?? positions).length / (indices ? 1 : 3); i += 3)
    yield [0, 1, 2].map((k) => (indices ? indices[i + k] : i + k))
}

/** Returns the signed volume of a closed mesh: it is above 0 if the front sides are outside. */
export function volumeOf(mesh) {
  let volume = 0
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    volume += dot(a, cross(b, c)) / 6
  }
  return volume
}

/** Returns the minimum cosine of the angles between a vertex normal and the normal of a triangle at that vertex. */
function minCosine(mesh) {
  let min = 1
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    const front = cross(minus(b, a), minus(c, a))
    const size = Math.hypot(...front)
    if (size < 1e-9) continue
    for (const i of corners) min = Math.min(min, dot(front, vec(mesh.normals, i)) / size)
  }
  return min
}

/** A fine sphere whose triangles have their fronts outside. */
export const round = (() => {
  const mesh = sphere(48, 32)
  const indices = mesh.indices.slice()
  if (volumeOf(mesh) < 0)
    for (let i = 0; i < indices.length; i += 3)
      [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]]
  return { ...mesh, indices }
})()

/** Asserts that the fronts of triangles and the normals point outwards. */
export function assertOutside(mesh, message) {
  const [volume, cosine] = [volumeOf(mesh), minCosine(mesh)]
  assert.ok(volume > 0.5, `${message}: expected a volume above 0.5, got ${volume}`)
  assert.ok(
    cosine > 0.5,
    `${message}: the angle of a normal to its triangle has the cosine ${cosine}`,
  )
}

export const mirror = ({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0)

/** Makes an offset function from a function that returns the new position. */
export const to = (move) => (inputs) => move(inputs).sub(inputs.position)

export const byUniform = to(({ glsl, position, uniforms }) =>
  glsl.vec3(position.x().mult(uniforms.scale), position.y(), position.z()),
)
