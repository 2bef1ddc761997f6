// Computes boxes and spheres around warped objects, for culling. They are never too small, and are computed again when the object or the
// warp has changed.
import { Box3, Matrix4, Sphere, Vector3, type BufferAttribute } from 'three'
import { instanceState, instancesOf } from './instances.js'
import { isMoved, poseState, type Warpable } from './pose.js'
import { boundsState, posedBox, posedFrom, restBox, restSphere } from './posed-bounds.js'
import { remembered } from './remembered.js'
import type { WarpSpace } from './settings.js'
import { fillOf } from './surface.js'
import type { ThreeWarp } from './three-warp.js'

const everything = () =>
  new Box3(new Vector3().setScalar(-Infinity), new Vector3().setScalar(Infinity))

/** Returns a box around the warped positions of all points in a box. */
export function warpedBox(warp: ThreeWarp, object: Warpable, box: Box3): Box3 {
  return warp.canRunOnCpu ? boundsBy('position', warp, object, box) : everything()
}

/** Returns a box around the warped positions, or the offsets, of all points in a box. */
function boundsBy(
  result: 'position' | 'offset',
  warp: ThreeWarp,
  object: Warpable,
  box: Box3,
): Box3 {
  if (box.isEmpty()) return box
  const { uv } = object.geometry.attributes
  const uvs = warp.reads('uv') && uv ? rangeOf(uv as never) : undefined
  if (isInfinite(box) || (uvs && ![...uvs.min, ...uvs.max].every(isFiniteFloat)))
    return everything()
  const { min, max } = warp.boundsNow(result, {
    min: box.min.toArray(),
    max: box.max.toArray(),
    ...(uvs && { uvs }),
  })
  const bounds = new Box3(new Vector3().fromArray(min), new Vector3().fromArray(max))
  // Bounds are empty if the warp is NaN everywhere. A GPU may compute something else, so the object is drawn.
  return bounds.isEmpty() ? everything() : bounds
}

/** Computes the range of texture coordinates. */
function rangeOf(uv: BufferAttribute) {
  const min = [Infinity, Infinity]
  const max = [-Infinity, -Infinity]
  for (let i = 0; i < uv.count; i++)
    for (const [k, value] of [uv.getX(i), uv.getY(i)].entries()) {
      min[k] = Math.min(min[k]!, value)
      max[k] = Math.max(max[k]!, value)
    }
  return { min, max }
}

/** Returns numbers that change when a warped object moves or is deformed. */
export function stateOf(warp: ThreeWarp, object: Warpable): number[] {
  const { drawRange, index } = object.geometry
  return [
    ...warp.numbers(),
    ...[drawRange.start, drawRange.count, index?.version ?? 0],
    ...(warp.reads('color') ? fillOf(object.material) : []),
    ...placeState(object, warp.settings.space),
  ]
}

/** Returns numbers that change when an object moves or is deformed before the warp. */
function placeState(object: Warpable, space: WarpSpace): number[] {
  return [
    ...poseState(object),
    ...boundsState(object),
    ...(space === 'world' ? object.matrixWorld.elements : []),
    ...instanceState(object),
  ]
}

/** A box and a sphere that bound the same points. */
export interface Extent {
  box: Box3
  sphere: Sphere
}

/**
 * Returns a function that returns the extent of the object as it is drawn, before its own matrix is applied. The extent is computed again
 * only after a change.
 */
export function extentOf(warp: ThreeWarp, object: Warpable): () => Extent {
  const unwarpedInWorld = remembered(
    () => placeState(object, 'world'),
    () => aroundInWorld(object),
  )
  return remembered(
    () => stateOf(warp, object),
    () => findExtent(warp, object, unwarpedInWorld),
  )
}

/** Returns an infinite extent, so that the object is never culled, if the warp, a vertex or a matrix yields a position that is not finite. */
function findExtent(warp: ThreeWarp, object: Warpable, unwarpedInWorld: () => Extent): Extent {
  if (!warp.canRunOnCpu) return extentOfBox(everything())
  const extent =
    warp.settings.space === 'world'
      ? extentInWorld(warp, object, unwarpedInWorld())
      : extentOfAll(warp, object)
  const { center, radius } = extent.sphere
  const isKnown = !isInfinite(extent.box) && [...center.toArray(), radius].every(Number.isFinite)
  return isKnown ? extent : extentOfBox(everything())
}

function extentOfAll(warp: ThreeWarp, object: Warpable): Extent {
  const one = extentOfOne(warp, object)
  if (isInfinite(one.box)) return one
  const all = extentOfBox(new Box3())
  for (const matrix of instancesOf(object).matrices) {
    all.box.union(one.box.clone().applyMatrix4(matrix))
    all.sphere.union(one.sphere.clone().applyMatrix4(matrix))
  }
  return { box: all.box, sphere: smallerSphere(all.sphere, sphereAround(all.box)) }
}

/** Bounds one instance, before its matrix is applied. */
function extentOfOne(warp: ThreeWarp, object: Warpable): Extent {
  const isRest = warp.settings.space === 'rest' && isMoved(object)
  const box = isRest ? restBox(object) : posedBox(object)
  const sphere = isMoved(object) ? sphereAround(box) : restSphere(object)
  const warped = warpedExtent(warp, object, { box, sphere })
  return isRest ? extentOfBox(posedFrom(object, warped.box)) : warped
}

/**
 * Bounds the warped points of an extent in two ways: by the image of its box, and by its sphere, moved and grown by the range of offsets.
 * The result has the box of the first way, and the smaller of the two spheres.
 */
function warpedExtent(warp: ThreeWarp, object: Warpable, { box, sphere }: Extent): Extent {
  const warped = extentOfBox(warpedBox(warp, object, box))
  const offsets = boundsBy('offset', warp, object, box)
  if (isInfinite(offsets) || offsets.isEmpty()) return warped
  const moved = new Sphere(
    offsets.getCenter(new Vector3()).add(sphere.center),
    (sphere.radius + offsets.getSize(new Vector3()).length() / 2) * slack,
  )
  return { box: warped.box, sphere: smallerSphere(moved, warped.sphere) }
}

const smallerSphere = (a: Sphere, b: Sphere) => (a.radius < b.radius ? a : b)

/** The factor by which spheres grow, since the sines of a GPU are less exact than those of the CPU. */
const slack = 1.001

/** Bounds all instances in the world, before the warp. */
function aroundInWorld(object: Warpable): Extent {
  const box = posedBox(object)
  const sphere = isMoved(object) ? sphereAround(box) : restSphere(object)
  const all = extentOfBox(new Box3())
  for (const matrix of instancesOf(object).matrices) {
    const toWorld = new Matrix4().multiplyMatrices(object.matrixWorld, matrix)
    const moved = sphere.clone().applyMatrix4(toWorld)
    all.box.union(box.clone().applyMatrix4(toWorld).intersect(moved.getBoundingBox(new Box3())))
    all.sphere.union(moved)
  }
  return all
}

/** Warps the bounds of all instances at once: one by one, ten thousand of them would take a second. */
function extentInWorld(warp: ThreeWarp, object: Warpable, unwarped: Extent): Extent {
  const warped = warpedExtent(warp, object, unwarped)
  if (isInfinite(warped.box)) return warped
  // Three.js will apply the object's matrix to the extent, and scales spheres by the matrix's largest scale.
  const back = new Matrix4().copy(object.matrixWorld).invert()
  return {
    box: warped.box.applyMatrix4(back),
    sphere: new Sphere(
      warped.sphere.center.applyMatrix4(back),
      warped.sphere.radius / object.matrixWorld.getMaxScaleOnAxis(),
    ),
  }
}

/**
 * Returns a function that bounds all warped instances of a geometry of a batch, from the geometry's extent at rest. In the world, where
 * each instance is warped differently, the bounds grow by the largest distance that any vertex of any instance moves.
 */
export function extentInBatch(warp: ThreeWarp, object: Warpable): (rest: Extent) => Extent {
  if (warp.settings.space !== 'world') return (rest) => warpedExtent(warp, object, rest)
  const offsets = boundsBy('offset', warp, object, aroundInWorld(object).box)
  if (isInfinite(offsets)) return () => extentOfBox(everything())
  const back = new Matrix4().copy(object.matrixWorld).invert().setPosition(0, 0, 0)
  const farthest = Math.max(
    ...cornersOf(offsets).map((corner) => corner.applyMatrix4(back).length()),
  )
  const scales = instancesOf(object).matrices.map((matrix) => matrix.getMaxScaleOnAxis())
  const reach = (slack * farthest) / Math.min(...scales.filter((scale) => scale > 0))
  return ({ box, sphere }) => ({
    box: box.expandByScalar(reach),
    sphere: new Sphere(sphere.center, sphere.radius + reach),
  })
}

const cornersOf = ({ min, max }: Box3) =>
  [min.x, max.x].flatMap((x) =>
    [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))),
  )

const isFiniteFloat = (number: number) => Number.isFinite(Math.fround(number))

/** An empty box does not count as infinite; a box with a NaN does. */
const isInfinite = (box: Box3) =>
  !box.isEmpty() && ![...box.min.toArray(), ...box.max.toArray()].every(isFiniteFloat)

/** Transforms a box. An infinite box stays infinite; multiplying its corners would give NaN, since infinity times zero is NaN. */
export const movedBox = (box: Box3, matrix: Matrix4): Box3 =>
  isInfinite(box) ? everything() : box.applyMatrix4(matrix)

const extentOfBox = (box: Box3): Extent => ({ box, sphere: sphereAround(box) })

export function sphereAround(box: Box3): Sphere {
  if (box.isEmpty()) return new Sphere(new Vector3(), -1)
  if (isInfinite(box)) return new Sphere(new Vector3(), Infinity)
  const sphere = box.getBoundingSphere(new Sphere())
  sphere.radius *= slack
  return sphere
}
