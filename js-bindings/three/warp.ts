// `warp`: an object of three.js, its shadows, its bounds and what rays meet, all warped.
import {
  type BatchedMesh,
  Box3,
  type Intersection,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  type Raycaster,
  Sphere,
} from 'three'
import { variationAttribute, variationNames } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { noteApproximation } from '../errors/notes.js'
import { describeOfThree, nameOf, spriteError } from './describe.js'
import { type Extent, extentInBatch, extentOf, movedBox, stateOf } from './extent.js'
import { ThreeWarp } from './three-warp.js'
import {
  type ShadowMaterials,
  type Warped,
  type Woven,
  shadowMaterials,
  updateOf,
} from './material.js'
import type { Warpable } from './pose.js'
import { type Raycast, raycastOf } from './rays.js'
import { remembered } from './remembered.js'
import { carryByNodes, checkForAll, refusing, weaveForAll } from './renderers.js'
import { type Settings, type ThreeOffset, type WarpOptions, readOptions } from './settings.js'
import type { ThreeUniforms, ValuesOf } from './uniforms.js'

export interface WarpedObject<Uniforms = {}> extends Warped<Uniforms> {
  /** Around what is drawn at present, in the units of the object, before its own matrix: never too small. Infinite where
   * only the GPU can run the warp, and where the warp or a vertex has no finite value. */
  bounds(): Box3
  /** What a `Raycaster` calls: hits on the warped surface are added to `intersects`. */
  raycast(raycaster: Raycaster, intersects: Intersection[]): void
}

/** Those that are warped at present. */
const warpedNow = new WeakSet<object>()

/**
 * Warps a mesh, points or lines, or all that is in a group: every vertex moves by the offset, normals and tangents turn as
 * its derivative says, shadows follow, what is visible is not culled, and rays meet what is seen. The geometry stays as it
 * is, and so do the materials, which are cloned, unless `share: true` says otherwise. Throws a `WarpError` for what cannot
 * be warped, such as a sprite, for an offset that returns no vec3 or misuses an operation, and for wrong options.
 * Whether WebGLRenderer or WebGPURenderer draws it need not be said, where `import 'warpjet/three/webgpu'` stands somewhere.
 */
export function warp<const Uniforms extends ThreeUniforms = {}>(
  object: Object3D,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpedObject<ValuesOf<Uniforms>> {
  const settings = readOptions('warp', options)
  const parts = partsOf(settings, object)
  const made = new ThreeWarp(offset as never, settings)
  for (const part of parts) checkInputs(made, part)
  const materials = new Map<Material, Woven>()
  const done = parts.map((part) => putOn(made, part, materials))
  return {
    uniforms: made.handles as never,
    update: updateOf(made),
    bounds: () => boundsOf(object, done),
    raycast: (raycaster, intersects) =>
      done.forEach(({ raycast }) => raycast(raycaster, intersects)),
    dispose() {
      for (const { restore } of done.splice(0)) restore()
      for (const { restore } of materials.values()) restore()
      materials.clear()
    },
  }
}

/** What is drawn of an object and all that is in it, checked before anything is changed. */
function partsOf({ method }: Settings, object: Object3D): Warpable[] {
  if (!object?.isObject3D)
    throw new WarpError(
      `${method}: a Mesh, Points, a Line or a group of them was expected, but ${describeOfThree(object)} came.`,
    )
  const parts: Warpable[] = []
  object.traverse((part) => {
    const { geometry, material } = part as Mesh
    if ((part as { isSprite?: boolean }).isSprite) throw spriteError(method, nameOf(part))
    if (!geometry || !material) return
    if (warpedNow.has(part))
      throw new WarpError(
        `${method}: ${nameOf(part)} is warped already; call dispose() of that warp first, or make one offset of both, as with chain of warpjet/deformers.`,
      )
    if (!geometry.attributes?.position)
      throw new WarpError(`${method}: the geometry of ${nameOf(part)} has no attribute "position".`)
    for (const each of [material].flat()) checkForAll(method, each, part as Mesh)
    parts.push(part as Warpable)
  })
  if (parts.length) return parts
  throw new WarpError(
    `${method}: there is nothing to draw in ${nameOf(object)}; add what is to be warped first.`,
  )
}

/** What the offset reads of each vertex is there. */
function checkInputs(warp: ThreeWarp, part: Warpable) {
  const remedies = {
    normal: 'call geometry.computeVertexNormals() first',
    uv: 'give it texture coordinates first',
  }
  for (const name of ['normal', 'uv'] as const)
    if (warp.reads(name) && !part.geometry.attributes[name])
      throw new WarpError(
        `${warp.settings.method}: the offset reads ${name}, but the geometry of ${nameOf(part)} has no attribute "${name}"; ${remedies[name]}.`,
      )
}

interface Part {
  object: Warpable
  raycast: Raycast
  bounds: () => Box3
  restore: () => void
}

/** Properties of an object that are given other values, and back. */
function replacing(object: object, properties: PropertyDescriptorMap) {
  const before = Object.keys(properties).map(
    (name) => [name, Object.getOwnPropertyDescriptor(object, name)] as const,
  )
  Object.defineProperties(
    object,
    Object.fromEntries(
      Object.entries(properties).map(([name, property]) => [
        name,
        { configurable: true, enumerable: true, ...property },
      ]),
    ),
  )
  return () => {
    for (const [name, property] of before) {
      if (property) Object.defineProperty(object, name, property)
      else Reflect.deleteProperty(object, name)
    }
  }
}

function putOn(warp: ThreeWarp, object: Warpable, materials: Map<Material, Woven>): Part {
  const wovenOf = (material: Material) => {
    if (!materials.has(material)) materials.set(material, weaveForAll(material, warp))
    return materials.get(material)!.material
  }
  if (warp.varies && warp.settings.surfaceVariation !== false && !hasVariation(object))
    noteApproximation(warp.settings.method, 'await addSurfaceVariation(geometry)')
  const before = object.material
  const surface = () => [object.material].flat()[0]!
  const shadows = shadowMaterials(warp, surface, object as ShadowMaterials)
  const extent = extentOf(warp, object)
  const raycast = raycastOf(warp, object, object.raycast, () => extent().sphere)
  object.material = Array.isArray(before) ? before.map(wovenOf) : wovenOf(before)
  const after = object.material
  const onBeforeRender = refusing(warp.settings, object as Mesh, () => object.material !== after)
  const putBack = replacing(object, {
    ...values(shadows),
    ...values({ raycast, onBeforeRender }),
    // Looked at before anything is drawn, so that uniforms may be set at any time.
    boundingSphere: answering(() => extent().sphere),
    boundingBox: answering(() => extent().box),
    ...values({ computeBoundingSphere() {}, computeBoundingBox() {} }),
    ...((object as BatchedMesh).isBatchedMesh && values(inBatch(warp, object as BatchedMesh))),
  })
  const release = carryByNodes(object, warp)
  warpedNow.add(object)
  return {
    object,
    raycast,
    bounds: () => extent().box.clone(),
    restore() {
      putBack()
      release()
      // Another material, put on meanwhile, stays.
      if (object.material === after) object.material = before
      shadows.customDepthMaterial.dispose()
      shadows.customDistanceMaterial.dispose()
      warpedNow.delete(object)
    },
  }
}

const values = (properties: object): PropertyDescriptorMap =>
  Object.fromEntries(
    Object.entries(properties).map(([name, value]) => [name, { value, writable: true }]),
  )

/** Three.js writes there too, when it computes what it would be without a warp. */
const answering = <Value extends Box3 | Sphere>(value: () => Value): PropertyDescriptor => ({
  get: value,
  set: () => {},
})

const hasVariation = ({ geometry }: Warpable) =>
  variationNames.some((name) => variationAttribute(name) in geometry.attributes)

/** A batch culls its instances one by one, by what is around each of its geometries. */
function inBatch(warp: ThreeWarp, object: BatchedMesh) {
  if (!warp.runs) return { perObjectFrustumCulled: false }
  const { getBoundingBoxAt, getBoundingSphereAt } = object
  // Of three.js, the sphere asks for the box of the object, which would be the warped one.
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

/** Of all parts, before the matrix of what was warped. */
function boundsOf(whole: Object3D, parts: readonly Part[]) {
  const back = new Matrix4().copy(whole.matrixWorld).invert()
  const all = new Box3()
  for (const { object, bounds } of parts) {
    const box = bounds()
    const isWhole = object === (whole as unknown)
    all.union(
      isWhole ? box : movedBox(box, new Matrix4().multiplyMatrices(back, object.matrixWorld)),
    )
  }
  return all
}
