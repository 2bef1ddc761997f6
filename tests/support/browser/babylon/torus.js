// A torus with waves: a warp moves the plain torus along its normals, or the mesh is built with the waves and their normals.
import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'

const [radius, tube] = [0.9, 0.35]
const height = (u, v) => 0.1 * Math.sin(12 * Math.PI * u) * Math.cos(8 * Math.PI * v)

/** Returns a point of a torus around y whose tube has a varying radius. */
function pointAt(u, v) {
  const [a, b] = [2 * Math.PI * u, 2 * Math.PI * v]
  const r = tube + height(u, v)
  const ring = radius + r * Math.cos(b)
  return new Vector3(ring * Math.cos(a), r * Math.sin(b), ring * Math.sin(a))
}

function normalAt(u, v) {
  const step = 1e-5
  const difference = (f) => f(step).subtract(f(-step))
  return Vector3.Cross(
    difference((h) => pointAt(u, v + h)),
    difference((h) => pointAt(u + h, v)),
  ).normalize()
}

/** Makes a mesh of the torus, with the waves if `isMoved`; its uvs are u and v. */
export function addTorus(scene, { isMoved }) {
  const [columns, rows] = [160, 96]
  const [positions, normals, uvs, indices] = [[], [], [], []]
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) {
      const [u, v] = [i / columns, j / rows]
      const [a, b] = [2 * Math.PI * u, 2 * Math.PI * v]
      const unitNormal = new Vector3(
        Math.cos(a) * Math.cos(b),
        Math.sin(b),
        Math.sin(a) * Math.cos(b),
      )
      const point = isMoved
        ? pointAt(u, v)
        : unitNormal.scale(tube).add(new Vector3(radius * Math.cos(a), 0, radius * Math.sin(a)))
      positions.push(...point.asArray())
      normals.push(...(isMoved ? normalAt(u, v) : unitNormal).asArray())
      uvs.push(u, v)
      if (i === columns || j === rows) continue
      const k = j * (columns + 1) + i
      indices.push(k, k + 1, k + columns + 1, k + 1, k + columns + 2, k + columns + 1)
    }
  const mesh = MeshBuilder.CreateBox('torus', {}, scene)
  mesh.setVerticesData(VertexBuffer.PositionKind, positions)
  mesh.setVerticesData(VertexBuffer.NormalKind, normals)
  mesh.setVerticesData(VertexBuffer.UVKind, uvs)
  mesh.setIndices(indices, positions.length / 3)
  mesh.refreshBoundingInfo()
  return mesh
}

/** The offset of the waves: along the normal by a height over uv. */
export const alongNormal = ({ normal, uv }) => {
  const [u, v] = [uv.x().mult(12 * Math.PI), uv.y().mult(8 * Math.PI)]
  return normal.mult(u.sin().mult(v.cos()).mult(0.1))
}
