// The instances of an InstancedMesh, a BatchedMesh, or an object of @three.ez/instanced-mesh.
import { Matrix4, type BatchedMesh, type InstancedMesh } from 'three'
import type { Warpable } from './pose.js'

/** Returns numbers that change when an instance moves, appears or disappears. */
export function instanceState(object: Warpable): number[] {
  const { instanceMatrix, count } = object as InstancedMesh
  return [
    ...(instanceMatrix ? [instanceMatrix.version, count] : []),
    ...batchState(object as BatchedMesh),
    // @three.ez/instanced-mesh has no version, so we treat its instances as moved each time: NaN never equals itself.
    ...(isInstancedMesh2(object) ? [NaN] : []),
  ]
}

/** Tests for an object of @three.ez/instanced-mesh. */
export const isInstancedMesh2 = (object: Warpable) =>
  (object as { isInstancedMesh2?: boolean }).isInstancedMesh2 === true

/** Returns the numbers of `instanceState` for a batch, which has the matrices of its instances in a texture, and flags for visible ones. */
function batchState(object: BatchedMesh): number[] {
  if (!object.isBatchedMesh) return []
  const { _matricesTexture: matrices } = object as unknown as {
    _matricesTexture?: { version: number }
  }
  return [matrices?.version ?? NaN, ...idsOf(object)]
}

/** Returns the matrix of each instance; the identity for an object without instances. */
export function instancesOf(object: Warpable): {
  matrices: Matrix4[]
  ids: (number | undefined)[]
} {
  const { isInstancedMesh, count } = object as InstancedMesh
  const { isBatchedMesh } = object as BatchedMesh
  if (!isInstancedMesh && !isBatchedMesh) return { matrices: [new Matrix4()], ids: [undefined] }
  const ids = isInstancedMesh ? Array.from({ length: count }, (_, i) => i) : idsOf(object)
  const matrices = ids.map((i) => {
    const matrix = new Matrix4()
    ;(object as InstancedMesh).getMatrixAt(i, matrix)
    return matrix
  })
  return { matrices, ids }
}

/** Returns the ids of the visible instances of a batch that were not deleted. Three.js 0.159 has a separate list of flags for them. */
function idsOf(object: Warpable): number[] {
  const { _instanceInfo, _active = [] } = object as unknown as {
    _instanceInfo?: { active: boolean; visible: boolean }[]
    _active?: boolean[]
  }
  const flags = _instanceInfo?.map(({ active, visible }) => active && visible) ?? _active
  return flags.flatMap((isVisible, i) => (isVisible ? i : []))
}
