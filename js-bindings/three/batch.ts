// A BatchedMesh culls its instances one by one, by the bounds of its geometries.
import { Box3, Sphere, type BatchedMesh } from 'three'
import { extentInBatch, stateOf, type Extent } from './extent.js'
import { remembered } from './remembered.js'
import type { ThreeWarp } from './three-warp.js'

/** The properties of a warped batch that cull its instances. */
export function batchProperties(warp: ThreeWarp, object: BatchedMesh) {
  if (!warp.canRunOnCpu) return { perObjectFrustumCulled: false }
  const { getBoundingBoxAt, getBoundingSphereAt } = object
  // The sphere of three.js calls the method for the box, which would be the warped one.
  const atRest = Object.create(object, { getBoundingBoxAt: { value: getBoundingBoxAt } }) as object
  const find = remembered(
    () => stateOf(warp, object),
    () => ({ extentOf: extentInBatch(warp, object), known: new Map<number, Extent>() }),
  )
  const extentAt = (id: number) => {
    const { extentOf, known } = find()
    if (!known.has(id)) {
      const box = getBoundingBoxAt.call(atRest as BatchedMesh, id, new Box3())
      const sphere = getBoundingSphereAt.call(atRest as BatchedMesh, id, new Sphere())
      if (!box || !sphere) return null
      known.set(id, extentOf({ box, sphere }))
    }
    return known.get(id)!
  }
  return {
    getBoundingBoxAt(id: number, target: Box3) {
      const extent = extentAt(id)
      return extent && target.copy(extent.box)
    },
    getBoundingSphereAt(id: number, target: Sphere) {
      const extent = extentAt(id)
      return extent && target.copy(extent.sphere)
    },
  }
}
