// Warps that mirror space, and a geometric check that the outer side of a closed mesh stays outside: the signed volume has the sign
// of the winding of the triangles, and each vertex normal must point to their front side.
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

/** The signed volume of a closed mesh: above 0 if the front sides are outside. */
export function volumeOf(mesh) {
  let volume = 0
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    volume += dot(a, cross(b, c)) / 6
  }
  return volume
}

/** The minimum cosine of the angle between a vertex normal and the front of a triangle around it. */
function minCosine(mesh) {
  let least = 1
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    const front = cross(minus(b, a), minus(c, a))
    const size = Math.hypot(...front)
    if (size < 1e-9) continue
    for (const i of corners) least = Math.min(least, dot(front, vec(mesh.normals, i)) / size)
  }
  return least
}

/** A fine mesh with its front outside. */
export const round = (() => {
  const mesh = sphere(48, 32)
  const indices = mesh.indices.slice()
  if (volumeOf(mesh) < 0)
    for (let i = 0; i < indices.length; i += 3)
      [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]]
  return { ...mesh, indices }
})()

export function isOutside(mesh, message) {
  const [volume, cosine] = [volumeOf(mesh), minCosine(mesh)]
  assert.ok(volume > 0.5, `${message}: the triangles enclose ${volume}`)
  assert.ok(cosine > 0.5, `${message}: a normal is off by the cosine ${cosine}`)
}

export const mirror = ({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0)

/** Makes an offset function from a function that returns the new position. */
export const to = (place) => (inputs) => place(inputs).sub(inputs.position)

export const byUniform = to(({ glsl, position, uniforms }) =>
  glsl.vec3(position.x().mult(uniforms.scale), position.y(), position.z()),
)
