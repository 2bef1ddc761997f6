// Rays meet the warped surface: three's own `raycast` runs on a stand-in of the object whose vertices are warped.
import {
  Matrix3,
  Matrix4,
  Mesh,
  type BatchedMesh,
  type BufferAttribute,
  type BufferGeometry,
  type InstancedMesh,
  type Intersection,
  type Raycaster,
  type Sphere,
  type Vector3,
} from 'three'
import type { DrawnSurface } from './detail/drawn-surface.js'
import { sphereAround, stateOf, warpedBox } from './extent.js'
import { withOtherSide } from './faces.js'
import { instancesOf } from './instances.js'
import type { Warpable } from './pose.js'
import { posedBox } from './posed-bounds.js'
import { remembered } from './remembered.js'
import { warpedGeometry } from './surface.js'
import type { ThreeWarp } from './three-warp.js'

export type Raycast = (raycaster: Raycaster, intersects: Intersection[]) => void

const warned = new WeakSet<ThreeWarp>()

/**
 * Creates the `raycast` of a warped object. `original` is its method without the warp. `bounds` returns a sphere around everything that is
 * drawn of the object, and `surfaceNow` the object's divided surface, if that is drawn.
 */
export function raycastOf(
  warp: ThreeWarp,
  object: Warpable,
  original: Raycast,
  bounds: () => Sphere,
  surfaceNow: () => DrawnSurface | undefined = () => undefined,
): Raycast {
  if (!warp.canRunOnCpu) return () => warnOfMiss(warp)
  const castOn = (each: Warpable): Cast =>
    warp.settings.space === 'world'
      ? castInWorld(warp, each, original)
      : castBeforeMatrix(warp, each, original)
  const castOnOriginal = castOn(object)
  const castOnDivided = memoizeLast((surface: DrawnSurface): Cast => {
    const castOnSurface = castOn(surface.object)
    return (raycaster, intersects, extent) => {
      const found: Intersection[] = []
      castOnSurface(raycaster, found, extent)
      for (const hit of found) intersects.push({ ...surface.toOwnTriangle(hit), object })
    }
  })
  return (raycaster, intersects) => {
    if (object.material === undefined || !isNear(raycaster, object, bounds(), object.matrixWorld))
      return
    const surface = surfaceNow()
    const castOne = surface ? castOnDivided(surface) : castOnOriginal
    castOne(raycaster, intersects, bounds())
  }
}

type Cast = (raycaster: Raycaster, intersects: Intersection[], extent: Sphere) => void

function memoizeLast<Key, Value>(work: (key: Key) => Value): (key: Key) => Value {
  let last: { readonly key: Key; readonly value: Value } | undefined
  return (key) => {
    if (last?.key !== key) last = { key, value: work(key) }
    return last.value
  }
}

/** Warns once that rays miss a warp that only the GPU can run. */
function warnOfMiss(warp: ThreeWarp) {
  if (warned.has(warp)) return
  warned.add(warp)
  console.warn(
    `${warp.settings.method}: rays miss a warp that calls a glsl.fn or reads an image, which only the GPU can run; raycast another object in its place.`,
  )
}

/** Tests whether the ray meets the sphere. Points and lines are as thick as the raycaster says, and always count as near. */
const isNear = ({ ray }: Raycaster, object: Warpable, sphere: Sphere, matrix: Matrix4) =>
  !(object as Mesh).isMesh || ray.intersectsSphere(sphere.clone().applyMatrix4(matrix))

/** Properties that hide the data of three-mesh-bvh and @three.ez/instanced-mesh about the unwarped geometry. */
const hiddenCaches = (geometry: BufferGeometry) => ({
  boundsTree: undefined,
  boundsTrees: undefined,
  bvh: null,
  _geometry: geometry,
})

/** Returns a stand-in for the object, with a geometry that no morph targets and no bones move. */
const standInFor = (
  object: Warpable,
  geometry: BufferGeometry,
  more: Record<string, unknown> = {},
) =>
  Object.create(
    object,
    Object.getOwnPropertyDescriptors({
      geometry,
      getVertexPosition: (i: number, target: Vector3) =>
        target.fromBufferAttribute(geometry.attributes.position as BufferAttribute, i),
      boundingSphere: geometry.boundingSphere,
      boundingBox: geometry.boundingBox,
      ...hiddenCaches(geometry),
      ...more,
    }),
  ) as Warpable

/** Returns the hits of three's own `raycast`. `isReversed` is true if the stand-in's triangles have their backs outside. */
function cast(original: Raycast, standIn: Warpable, isReversed: boolean, raycaster: Raycaster) {
  const found: Intersection[] = []
  if (!isReversed || !(standIn as Mesh).isMesh) {
    original.call(standIn, raycaster, found)
    return found
  }
  original.call(
    Object.assign(standIn, { material: withOtherSide(standIn.material) }) as never,
    raycaster,
    found,
  )
  for (const { face } of found) face?.normal.negate()
  return found
}

/** Casts in the spaces before the object's matrix, where all instances have one surface. */
function castBeforeMatrix(warp: ThreeWarp, object: Warpable, original: Raycast) {
  const geometry = remembered(
    () => stateOf(warp, object),
    () => warpedGeometry(warp, object),
  )
  const isRest = warp.settings.space === 'rest'
  const hasInstances = (object as InstancedMesh).isInstancedMesh
  return (raycaster: Raycaster, intersects: Intersection[], extent: Sphere) => {
    const warped = geometry()
    // Morph targets and bones move the vertices further, but not out of the extent of the whole object.
    if (isRest) Object.assign(warped, { boundingSphere: extent, boundingBox: null })
    const standIn = standInFor(object, warped, {
      ...(isRest && { getVertexPosition: (object as Mesh).getVertexPosition }),
      ...(hasInstances && { boundingSphere: extent, boundingBox: null }),
    })
    const hits = cast(original, standIn, warp.isMirroredNow(), raycaster)
    for (const hit of hits.filter(hasDistance)) intersects.push({ ...hit, object })
  }
}

/** Casts in the world, on one instance after the other. */
function castInWorld(warp: ThreeWarp, object: Warpable, original: Raycast) {
  const isBatch = (object as BatchedMesh).isBatchedMesh
  const hasInstances = isBatch || (object as InstancedMesh).isInstancedMesh
  const instances = remembered(
    () => stateOf(warp, object),
    () => {
      const { matrices, ids } = instancesOf(object)
      return matrices.map((matrix, i) => instanceOf(warp, object, matrix, ids[i]))
    },
  )
  return (raycaster: Raycaster, intersects: Intersection[]) => {
    for (const { id, toWorld, sphere, geometry } of instances()) {
      if (!isNear(raycaster, object, sphere(), identity)) continue
      const warped = geometry()
      const range = isBatch && rangeOf(object as BatchedMesh, id!)
      if (range) warped.setDrawRange(range.start, range.count)
      const standIn = standInFor(object, warped, { matrixWorld: identity })
      const raycastInstance = hasInstances ? (Mesh.prototype.raycast as Raycast) : original
      // The triangles are in world space here, where a matrix that mirrors has turned them over.
      const isReversed = warp.isMirroredNow() !== toWorld.determinant() < 0
      const hits = cast(raycastInstance, standIn, isReversed, raycaster)
      for (const hit of hits.filter(hasDistance))
        intersects.push({
          ...withLocalNormals(hit, toWorld),
          object,
          ...(id !== undefined && { [isBatch ? 'batchId' : 'instanceId']: id }),
        })
    }
  }
}

/** Tests for a hit at a finite distance: three.js reports that every ray hits a triangle with a vertex that is NaN, at the distance NaN. */
const hasDistance = ({ distance }: Intersection) => Number.isFinite(distance)

const identity = new Matrix4()

function instanceOf(warp: ThreeWarp, object: Warpable, matrix: Matrix4, id: number | undefined) {
  const toWorld = new Matrix4().multiplyMatrices(object.matrixWorld, matrix)
  const once = <Value>(work: () => Value) => remembered(() => [], work)
  return {
    id,
    toWorld,
    sphere: once(() =>
      sphereAround(warpedBox(warp, object, posedBox(object).clone().applyMatrix4(toWorld))),
    ),
    geometry: once(() => warpedGeometry(warp, object, toWorld)),
  }
}

/** Transforms the normals of a hit to the space before the matrix of the object or the instance, as three.js returns them. */
function withLocalNormals(hit: Intersection, toWorld: Matrix4): Intersection {
  const back = new Matrix3().setFromMatrix4(toWorld).transpose()
  for (const normal of [hit.face?.normal, hit.normal]) normal?.applyMatrix3(back).normalize()
  return hit
}

/** Returns the range of the batch's triangles that an instance draws. */
function rangeOf(object: BatchedMesh, id: number) {
  const geometry = object.getGeometryIdAt?.(id) ?? id
  const range = object.getGeometryRangeAt?.(geometry)
  if (range) return range
  const { _drawRanges } = object as unknown as { _drawRanges: { start: number; count: number }[] }
  return _drawRanges[geometry]!
}
