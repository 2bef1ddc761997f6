// Warps one object: replaces the properties that renderers, culling, rays and clones read.
import type { BatchedMesh, Box3, InstancedMesh, Mesh, Object3D } from 'three'
import { batchProperties } from './batch.js'
import { DetailedPart } from './detail/detailed-part.js'
import { extentOf } from './extent.js'
import { isInstancedMesh2 } from './instances.js'
import type { Warpable } from './pose.js'
import { asProperties, computedProperty, replaceProperties, wrapMethod } from './properties.js'
import { raycastOf, type Raycast } from './rays.js'
import { isWarped, register, unregister } from './registry.js'
import { attachToWebGPU, prepareRenderer } from './renderers.js'
import type { Variants } from './variants.js'

export interface Part {
  readonly object: Warpable
  raycast: Raycast
  bounds: () => Box3
  release: () => void
}

/** Warps one object. `adopt` is called for each of its clones. */
export function warpPart(
  variants: Variants,
  object: Warpable,
  adopt: (clone: Object3D) => void,
): Part {
  const { warp } = variants
  const detail = warp.settings.detail === undefined ? undefined : new DetailedPart(warp, object)
  const extent = extentOf(warp, detail?.undivided ?? object)
  const boundingSphere = () => extent().sphere
  const restore = [
    ...['onBeforeRender', 'onBeforeShadow'].map((name) =>
      wrapMethod<Mesh['onBeforeRender']>(object, name, (original) => {
        return function (this: Mesh, renderer, ...others) {
          prepareRenderer(renderer, warp, object)
          detail?.enterScene()
          original?.call(this, renderer, ...others)
        }
      }),
    ),
    wrapMethod<Raycast>(object, 'raycast', (original) =>
      raycastOf(warp, object, original, boundingSphere, () => detail?.surfaceNow()),
    ),
    wrapMethod<Object3D['clone']>(object, 'clone', (original) => {
      return function (this: Object3D, recursive) {
        const clone = original.call(this, recursive)
        if (!isWarped(clone)) adopt(clone)
        return clone
      }
    }),
    replaceProperties(object, {
      // The bounds are computed when they are read, so that uniforms may be set at any time.
      boundingSphere: computedProperty(boundingSphere),
      boundingBox: computedProperty(() => extent().box),
      ...asProperties({ computeBoundingSphere() {}, computeBoundingBox() {} }),
      ...((object as BatchedMesh).isBatchedMesh &&
        asProperties(batchProperties(warp, object as BatchedMesh))),
    }),
    isInstancedMesh2(object) ? showAllInstances(object as never) : () => {},
    attachToWebGPU(object, warp),
    () => unregister(object),
    detail ? drawDivided(detail) : () => {},
  ]
  register(object, variants)
  return {
    object,
    // Reads the method each time, since another one may have been assigned.
    raycast: (raycaster, intersects) => object.raycast(raycaster, intersects),
    bounds: () => extent().box.clone(),
    release() {
      for (const each of restore.splice(0).reverse()) each()
    },
  }
}

/** Makes `detail` enter the scene of its object whenever matrices are updated, which three.js does before it calls the scene's hooks. */
function drawDivided(detail: DetailedPart) {
  const stop = wrapMethod<Object3D['updateMatrixWorld']>(
    detail.object,
    'updateMatrixWorld',
    (original) =>
      function (this: Object3D, force) {
        original.call(this, force)
        detail.enterScene()
      },
  )
  detail.enterScene()
  return () => {
    stop()
    detail.dispose()
  }
}

/** Disables the culling by which @three.ez/instanced-mesh hides instances: that culling uses the bounds of the unwarped geometry. */
function showAllInstances(object: { perObjectFrustumCulled: boolean }) {
  const before = object.perObjectFrustumCulled
  object.perObjectFrustumCulled = false
  return () => void (object.perObjectFrustumCulled = before)
}

/** Removes the bounds that three.js copies to a clone, since they are those of the warped object. */
export function forgetBounds(clone: Object3D) {
  const { boundingBox, boundingSphere } = clone as InstancedMesh
  if (boundingBox) (clone as InstancedMesh).boundingBox = null
  if (boundingSphere) (clone as InstancedMesh).boundingSphere = null
}
