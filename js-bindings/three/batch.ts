// A BatchedMesh culls its instances one by one, by the bounds of its geometries.
import { Box3, Sphere, type BatchedMesh } from 'three'
import { extentInBatch, stateOf, type Extent } from './extent.js'
import { remembered } from './remembered.js'
import type { ThreeWarp } from './three-warp.js'

/** Returns properties for a warped batch by which three.js culls its instances. */
export function batchProperties(warp: ThreeWarp, object: BatchedMesh) {
  if (!warp.canRunOnCpu) return { perObjectFrustumCulled: false }
  const { getBoundingBoxAt, getBoundingSphereAt } = object
  // Three.js' getBoundingSphereAt calls getBoundingBoxAt of its object, which would return the warped box.
  const unwarped = Object.create(object, {
    getBoundingBoxAt: { value: getBoundingBoxAt },
  }) as object
  const currentExtents = remembered(
    () => stateOf(warp, object),
    () => ({ extentOf: extentInBatch(warp, object), extents: new Map<number, Extent>() }),
  )
  const extentAt = (id: number) => {
    const { extentOf, extents } = currentExtents()
    if (!extents.has(id)) {
      const box = getBoundingBoxAt.call(unwarped as BatchedMesh, id, new Box3())
      const sphere = getBoundingSphereAt.call(unwarped as BatchedMesh, id, new Sphere())
      if (!box || !sphere) return null
      extents.set(id, extentOf({ box, sphere }))
    }
    return extents.get(id)!
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
