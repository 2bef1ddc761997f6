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

const noted = new WeakSet<ThreeWarp>()

/**
 * Creates the `raycast` of a warped object. `own` is its method without the warp, and `around` bounds everything that is drawn of it.
 * `surfaceNow` returns its divided surface, if it is drawn so.
 */
export function raycastOf(
  warp: ThreeWarp,
  object: Warpable,
  own: Raycast,
  around: () => Sphere,
  surfaceNow: () => DrawnSurface | undefined = () => undefined,
): Raycast {
  if (!warp.canRunOnCpu) return () => noteMiss(warp)
  const castOn = (each: Warpable): Cast =>
    warp.settings.space === 'world' ? castInWorld(warp, each, own) : castHere(warp, each, own)
  const castOnOwn = castOn(object)
  const castOnDivided = memoizeLast((surface: DrawnSurface): Cast => {
    const castOnSurface = castOn(surface.object)
    return (raycaster, intersects, extent) => {
      const found: Intersection[] = []
      castOnSurface(raycaster, found, extent)
      for (const hit of found) intersects.push({ ...surface.toOwnTriangle(hit), object })
    }
  })
  return (raycaster, intersects) => {
    if (object.material === undefined || !isNear(raycaster, object, around(), object.matrixWorld))
      return
    const surface = surfaceNow()
    const castOne = surface ? castOnDivided(surface) : castOnOwn
    castOne(raycaster, intersects, around())
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
function noteMiss(warp: ThreeWarp) {
  if (noted.has(warp)) return
  noted.add(warp)
  console.warn(
    `${warp.settings.method}: rays miss a warp that calls a glsl.fn or reads an image, which only the GPU can run; raycast another object in its place.`,
  )
}

/** Tests whether the ray meets the sphere. Points and lines are as thick as the raycaster says, and always count as near. */
const isNear = ({ ray }: Raycaster, object: Warpable, sphere: Sphere, matrix: Matrix4) =>
  !(object as Mesh).isMesh || ray.intersectsSphere(sphere.clone().applyMatrix4(matrix))

/** Hides what three-mesh-bvh and @three.ez/instanced-mesh know about the unwarped geometry. */
const ofOthers = (geometry: BufferGeometry) => ({
  boundsTree: undefined,
  boundsTrees: undefined,
  bvh: null,
  _geometry: geometry,
})

/** The object with a geometry that no morph targets and no bones move. */
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
      ...ofOthers(geometry),
      ...more,
    }),
  ) as Warpable

/** The hits of three's own `raycast`. `isReversed` is `true` if the back of its triangles is outside. */
function cast(own: Raycast, standIn: Warpable, isReversed: boolean, raycaster: Raycaster) {
  const found: Intersection[] = []
  if (!isReversed || !(standIn as Mesh).isMesh) {
    own.call(standIn, raycaster, found)
    return found
  }
  own.call(
    Object.assign(standIn, { material: withOtherSide(standIn.material) }) as never,
    raycaster,
    found,
  )
  for (const { face } of found) face?.normal.negate()
  return found
}

/** Casts in the spaces before the object's matrix, where all instances have one surface. */
function castHere(warp: ThreeWarp, object: Warpable, own: Raycast) {
  const geometry = remembered(
    () => stateOf(warp, object),
    () => warpedGeometry(warp, object),
  )
  const isRest = warp.settings.space === 'rest'
  const isMany = (object as InstancedMesh).isInstancedMesh
  return (raycaster: Raycaster, intersects: Intersection[], extent: Sphere) => {
    const warped = geometry()
    // Morph targets and bones go on from there, to at most the extent of the whole.
    if (isRest) Object.assign(warped, { boundingSphere: extent, boundingBox: null })
    const standIn = standInFor(object, warped, {
      ...(isRest && { getVertexPosition: (object as Mesh).getVertexPosition }),
      ...(isMany && { boundingSphere: extent, boundingBox: null }),
    })
    const hits = cast(own, standIn, warp.isMirroredNow(), raycaster)
    for (const hit of hits.filter(isPlace)) intersects.push({ ...hit, object })
  }
}

/** Casts in the world, on one instance after the other. */
function castInWorld(warp: ThreeWarp, object: Warpable, own: Raycast) {
  const isBatch = (object as BatchedMesh).isBatchedMesh
  const isMany = isBatch || (object as InstancedMesh).isInstancedMesh
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
      const ownHere = isMany ? (Mesh.prototype.raycast as Raycast) : own
      // A matrix that mirrors has turned the triangles over, since they are in the world here.
      const isReversed = warp.isMirroredNow() !== toWorld.determinant() < 0
      const hits = cast(ownHere, standIn, isReversed, raycaster)
      for (const hit of hits.filter(isPlace))
        intersects.push({
          ...turnedBack(hit, toWorld),
          object,
          ...(id !== undefined && { [isBatch ? 'batchId' : 'instanceId']: id }),
        })
    }
  }
}

/** Three.js has every ray meet a triangle with a vertex that is NaN, at the distance NaN. */
const isPlace = ({ distance }: Intersection) => Number.isFinite(distance)

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

/** Transforms normals to the space before the matrix of the object or the instance, as three.js returns them. */
function turnedBack(hit: Intersection, toWorld: Matrix4): Intersection {
  const back = new Matrix3().setFromMatrix4(toWorld).transpose()
  for (const normal of [hit.face?.normal, hit.normal]) normal?.applyMatrix3(back).normalize()
  return hit
}

/** The range of the batch's triangles that an instance shows. */
function rangeOf(object: BatchedMesh, id: number) {
  const geometry = object.getGeometryIdAt?.(id) ?? id
  const range = object.getGeometryRangeAt?.(geometry)
  if (range) return range
  const { _drawRanges } = object as unknown as { _drawRanges: { start: number; count: number }[] }
  return _drawRanges[geometry]!
}
