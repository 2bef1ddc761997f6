// How far a warped object extends, for culling: boxes from `bounds`, which are never too small, again when something changed.
import { type BatchedMesh, Box3, type InstancedMesh, Matrix4, Sphere, Vector3 } from 'three'
import type { ThreeWarp } from './kept.js'
import { type Warpable, boxOf, poseState, posedBox, posedFrom } from './pose.js'

const everything = () =>
  new Box3(new Vector3().setScalar(-Infinity), new Vector3().setScalar(Infinity))

/** A box around all that the warp makes of one. */
export function warpedBox(warp: ThreeWarp, object: Warpable, box: Box3): Box3 {
  if (!warp.runs) return everything()
  if (box.isEmpty()) return box
  const { uv } = object.geometry.attributes
  const uvs = warp.reads.has('uv') && uv ? rangeOf(uv as never) : undefined
  const { min, max } = warp.cpu.bounds(
    { min: box.min.toArray(), max: box.max.toArray(), ...(uvs && { uvs }) },
    { uniforms: warp.given() },
  )
  return new Box3(new Vector3().fromArray(min), new Vector3().fromArray(max))
}

/** Of texture coordinates, which have no third one. */
function rangeOf(uv: Parameters<typeof boxOf>[0]) {
  const min = [Infinity, Infinity]
  const max = [-Infinity, -Infinity]
  for (let i = 0; i < uv.count; i++)
    for (const [k, value] of [uv.getX(i), uv.getY(i)].entries()) {
      min[k] = Math.min(min[k]!, value)
      max[k] = Math.max(max[k]!, value)
    }
  return { min, max }
}

/** Remembers what `work` gave for as long as `state` gives the same numbers. */
export function remembered<Result>(state: () => number[], work: () => Result): () => Result {
  let last: number[] | undefined
  let result: Result
  return () => {
    const now = state()
    if (last?.length !== now.length || now.some((number, i) => number !== last![i])) {
      result = work()
      last = now
    }
    return result
  }
}

/** What changes where an object is, beside the warp. */
export function stateOf(warp: ThreeWarp, object: Warpable): number[] {
  const { instanceMatrix, count } = object as InstancedMesh
  return [
    ...warp.numbers(),
    ...poseState(object),
    ...(warp.settings.space === 'world' ? object.matrixWorld.elements : []),
    ...(instanceMatrix ? [instanceMatrix.version, count] : []),
    ...batchState(object as BatchedMesh),
  ]
}

/** A batch keeps the matrices of its instances in a texture. */
function batchState(object: BatchedMesh) {
  if (!object.isBatchedMesh) return []
  const { _matricesTexture: matrices } = object as unknown as {
    _matricesTexture?: { version: number }
  }
  return [matrices?.version ?? NaN]
}

/** The matrix of each instance; of what has none a single one that changes nothing. */
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

/** Those of a batch that were not deleted; three.js 0.159 keeps them in a list of their own. */
function idsOf(object: Warpable): number[] {
  const { _instanceInfo, _active = [] } = object as unknown as {
    _instanceInfo?: { active: boolean; visible: boolean }[]
    _active?: boolean[]
  }
  const isThere = _instanceInfo?.map(({ active, visible }) => active && visible) ?? _active
  return isThere.flatMap((is, i) => (is ? i : []))
}

/** In the space of the object, as three.js wants it: what is warped of one instance, before its matrix. */
function boxBefore(warp: ThreeWarp, object: Warpable): Box3 {
  if (warp.settings.space === 'rest')
    return posedFrom(
      object,
      warpedBox(warp, object, boxOf(object.geometry.attributes.position as never)),
    )
  return warpedBox(warp, object, posedBox(object))
}

/** A box around the whole object as it is drawn, before its own matrix. */
export function extentOf(warp: ThreeWarp, object: Warpable): Box3 {
  if (!warp.runs) return everything()
  const { matrices } = instancesOf(object)
  const all = new Box3()
  if (warp.settings.space !== 'world') {
    const box = boxBefore(warp, object)
    if (isInfinite(box)) return everything()
    for (const matrix of matrices) all.union(box.clone().applyMatrix4(matrix))
    return all
  }
  // One box around all instances is warped at once: ten thousand of them would take a second.
  const box = posedBox(object)
  for (const matrix of matrices)
    all.union(box.clone().applyMatrix4(matrix).applyMatrix4(object.matrixWorld))
  const warped = warpedBox(warp, object, all)
  if (isInfinite(warped)) return everything()
  return warped.applyMatrix4(new Matrix4().copy(object.matrixWorld).invert())
}

const isInfinite = ({ min, max }: Box3) =>
  [...min.toArray(), ...max.toArray()].some((number) => !Number.isFinite(number))

/** A sphere around a box, by a thousandth larger: sines of a GPU are less exact than those of the CPU. */
export function sphereAround(box: Box3): Sphere {
  if (box.isEmpty()) return new Sphere(new Vector3(), -1)
  if (isInfinite(box)) return new Sphere(new Vector3(), Infinity)
  const sphere = box.getBoundingSphere(new Sphere())
  sphere.radius *= 1.001
  return sphere
}
