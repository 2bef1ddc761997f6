// Warps the vertices of a mesh on the CPU, for rays and culling.
import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { HostWarp } from '../compile/hosts.js'
import { describe } from '../errors/errors.js'
import { Place } from '../options/place.js'

const place = new Place('refresh')

/** Half the size of a bounding box that contains everything. */
const maxCoordinate = 1e30

/** The private property of a mesh in which Babylon.js stores positions after bones and morph targets, for picking. */
interface WithPositions {
  _internalAbstractMeshDataInfo: { _positions: Vector3[] | null }
}

export function refreshMesh(warp: HostWarp, mesh: AbstractMesh, inputs: { millis: number }) {
  const positions = (mesh as Partial<AbstractMesh> | undefined)?.getPositionData?.(false, true)
  if (!positions) throw place.expected('a mesh of Babylon.js with vertices', describe(mesh))
  if (!warp.canRunOnCpu)
    throw place.error(
      'this warp calls a glsl.fn or reads an image, which only the GPU can do; pick another mesh instead of this one.',
    )
  const read = (kind: string, size: number) => {
    const numbers = mesh.getVerticesData(kind)
    return numbers && numbers.length === (positions.length / 3) * size ? numbers : undefined
  }
  const count = positions.length / 3
  const normals = mesh.getNormalsData(false, true) ?? undefined
  const uvs = read(VertexBuffer.UVKind, 2)
  const colors = read(VertexBuffer.ColorKind, 4) ?? new Float32Array(4 * count).fill(1)
  const vertices = { positions, colors, ...(normals && { normals }), ...(uvs && { uvs }) }
  const warped = warp.evaluate(vertices, inputs)
  // Bones are applied after the warp.
  setPositions(mesh, mesh.getPositionData(true, false, warped.positions) ?? warped.positions)
}

/** Makes picking and culling of a mesh use these positions. */
function setPositions(mesh: AbstractMesh, positions: ArrayLike<number>) {
  const points: Vector3[] = []
  const [min, max] = [new Vector3(), new Vector3()]
  min.setAll(Infinity)
  max.setAll(-Infinity)
  for (let i = 0; i < positions.length; i += 3) {
    const point = new Vector3(positions[i], positions[i + 1], positions[i + 2])
    points.push(point)
    min.minimizeInPlace(point)
    max.maximizeInPlace(point)
  }
  // Babylon.js needs finite bounds. Instead of a bound that is infinite or NaN, we use one that contains everything, so that the mesh is
  // drawn.
  for (const axis of ['x', 'y', 'z'] as const) {
    if (!Number.isFinite(min[axis])) min[axis] = -maxCoordinate
    if (!Number.isFinite(max[axis])) max[axis] = maxCoordinate
  }
  const { sourceMesh } = mesh as { sourceMesh?: AbstractMesh }
  ;((sourceMesh ?? mesh) as unknown as WithPositions)._internalAbstractMeshDataInfo._positions =
    points
  mesh.buildBoundingInfo(min, max, mesh.computeWorldMatrix(true))
  for (const subMesh of mesh.subMeshes.length > 1 ? mesh.subMeshes : [])
    subMesh.refreshBoundingInfo(positions as Float32Array)
}
