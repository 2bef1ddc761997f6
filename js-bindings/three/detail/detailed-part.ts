/** The option `detail` of `warp`: one object that is drawn with as many triangles as its warped surface needs on the screen. */
import {
  IntType,
  type BatchedMesh,
  type BufferGeometry,
  type InstancedBufferGeometry,
  type InstancedMesh,
  type Mesh,
} from 'three'
import { DetailedMesh, type DetailViews, type ToSpace } from '../../detail/detailed-mesh.js'
import { versionOf } from '../attribute.js'
import { nameOf } from '../describe.js'
import { isInstancedMesh2 } from '../instances.js'
import { warnOfDetail } from '../notes.js'
import { isSkinned, morphTextureOf, poseState, type Warpable } from '../pose.js'
import { remembered } from '../remembered.js'
import { fillOf, inWorld } from '../surface.js'
import type { ThreeWarp } from '../three-warp.js'
import { baseOf, isOfBones, isOfInstances, poseBase, type GeometryBase } from './base.js'
import { DividedGeometry } from './divided-geometry.js'
import { drawnSurfaceOf, type DrawnSurface } from './drawn-surface.js'
import type { Render } from './render.js'
import { addToScene, sceneOf, type Divisible } from './scenes.js'
import { viewsOf } from './views.js'

/** The object with its own vertices, also while it is drawn with others. */
const withOwnGeometry = (object: Warpable, geometry: () => BufferGeometry) =>
  Object.create(object, {
    geometry: { get: geometry },
    isSkinnedMesh: { value: isSkinned(object) },
  }) as Warpable

interface Divided {
  readonly mesh: DetailedMesh
  readonly drawn: DividedGeometry
  /** Moves the mesh by morph targets and bones, if they have changed, and returns its base. */
  readonly pose: () => GeometryBase
}

export class DetailedPart implements Divisible {
  readonly undivided: Warpable
  /** The user's geometry, while the object has another one. */
  private own: BufferGeometry | undefined
  private divided: Divided | undefined
  private leave: (() => void) | undefined
  private scene: object | undefined
  private stopListening = () => {}
  private readonly update: () => void
  private readonly toWorld: ToSpace | undefined
  /** The views of the last frame. */
  private views: DetailViews = []
  /** The surface that rays meet, for this version of the mesh. */
  private surface: (DrawnSurface & { readonly version: number }) | undefined

  constructor(
    private readonly warp: ThreeWarp,
    readonly object: Warpable,
  ) {
    this.undivided = withOwnGeometry(object, () => this.own ?? object.geometry)
    this.update = remembered(
      () => baseState(warp, object as Mesh),
      () => this.start(),
    )
    if (warp.settings.space === 'world') this.toWorld = toWorldOf(warp, object)
  }

  /** Divides the object when the scene that it is in now is rendered. */
  enterScene() {
    const scene = sceneOf(this.object)
    if (scene === this.scene) return
    this.leave?.()
    this.scene = scene
    this.leave = scene && addToScene(scene, this)
  }

  divide(render: Render) {
    const { object, warp } = this
    if (this.own) return
    this.enterScene()
    if (this.scene !== render.scene || !isShown(this.object, render)) return
    this.update()
    if (!this.divided) return
    const views = viewsOf(warp, object as Mesh, render)
    if (!views.length) return
    const { mesh, drawn } = this.divided
    this.views = views
    this.updateMesh(this.divided)
    drawn.write(mesh)
    this.own = object.geometry
    object.geometry = drawn.geometry
    // Bones have moved the divided vertices already, and morph targets are not in the geometry.
    if (isSkinned(object)) Object.assign(object, { isSkinnedMesh: false })
  }

  private updateMesh({ mesh, pose }: Divided) {
    const { warp, object, toWorld, views } = this
    const place = toWorld ? object.matrixWorld.elements : []
    const base = pose()
    mesh.update(warp.given, views, warp.settings.detail!.tolerance, toWorld, place)
    return base
  }

  /** The surface as the last frame would show it now; `undefined` if none has shown it divided. */
  surfaceNow(): DrawnSurface | undefined {
    if (!this.own) this.update()
    const { divided } = this
    if (!divided || !this.views.length) return undefined
    const base = this.updateMesh(divided)
    const { version } = divided.mesh
    if (this.surface?.version !== version)
      this.surface = { version, ...drawnSurfaceOf(this.object, base, divided.mesh) }
    return this.surface
  }

  restore() {
    if (!this.own) return
    if (isSkinned(this.undivided)) Object.assign(this.object, { isSkinnedMesh: true })
    // The user may have assigned another one meanwhile.
    if (this.object.geometry === this.divided?.drawn.geometry) this.object.geometry = this.own
    this.own = undefined
  }

  dispose() {
    this.leave?.()
    this.leave = this.scene = undefined
    this.free()
  }

  private free() {
    this.stopListening()
    this.divided?.mesh.dispose()
    this.divided?.drawn.dispose()
    this.divided = this.surface = undefined
    this.views = []
  }

  /** Starts anew with the present geometry. */
  private start() {
    const { warp, object } = this
    this.free()
    const problem = problemOf(warp, object)
    if (problem) return warnOfDetail(warp, nameOf(object), problem)
    const { geometry } = object
    const base = baseOf(warp, object as Mesh)
    const { isCurved } = warp.settings.detail!
    const mesh = new DetailedMesh(warp, { ...base, isCurved })
    const drawn = new DividedGeometry(base, geometry)
    const pose = hasPose(object)
      ? remembered(
          () => poseState(this.undivided),
          () => {
            const posed = poseBase(base, this.undivided as Mesh)
            mesh.pose(posed)
            return posed
          },
        )
      : () => base
    this.divided = { mesh, drawn, pose }
    // Like three.js, which makes its buffers anew when a disposed geometry is drawn again.
    const onDispose = () => drawn.dispose()
    geometry.addEventListener('dispose', onDispose)
    this.stopListening = () => geometry.removeEventListener('dispose', onDispose)
  }
}

/** Tests whether the object may be in the picture. */
function isShown(object: Warpable, { camera }: Render): boolean {
  if (!object.layers.test(camera.layers)) return false
  for (let each: { visible: boolean; parent: unknown } | null = object; each;)
    if (!each.visible) return false
    else each = each.parent as typeof each
  return true
}

/** Numbers that change when the arrays of the base do. */
function baseState(warp: ThreeWarp, object: Mesh): number[] {
  const { geometry, material } = object
  const { index, groups, drawRange, attributes, morphAttributes } = geometry
  return [
    numberOf(geometry),
    ...Object.values(attributes)
      .filter((attribute) => !isOfInstances(attribute))
      .flatMap((attribute) => [numberOf(attribute), versionOf(attribute)]),
    ...(index ? [numberOf(index), index.version] : []),
    ...Object.values(morphAttributes).map(({ length }) => length),
    ...[drawRange.start, drawRange.count],
    ...(Array.isArray(material)
      ? groups.flatMap(({ start, count, materialIndex }) => [start, count, materialIndex ?? -1])
      : [-2]),
    ...(warp.reads('color')
      ? [Number([material].flat()[0]!.vertexColors), ...fillOf(material)]
      : []),
  ]
}

const numbers = new WeakMap<object, number>()
let last = 0

/** A number that no other object has. */
function numberOf(object: object): number {
  let number = numbers.get(object)
  if (!number) numbers.set(object, (number = ++last))
  return number
}

/** Brings samples into the world as the object is now. */
function toWorldOf(warp: ThreeWarp, object: Warpable): ToSpace {
  const readsOthers = warp.reads('normal')
  return (samples, positions) => {
    const { normals, ...others } = samples
    const placed = inWorld({ ...others, ...(readsOthers && { normals }) }, object.matrixWorld)
    positions.set(placed.positions)
    return { ...placed, positions }
  }
}

const hasPose = (object: Warpable) =>
  isSkinned(object) ||
  Object.values(object.geometry.morphAttributes).some((targets) => targets.length > 0)

/** Describes why an object is drawn with its own vertices; `undefined` if it is divided. */
function problemOf(warp: ThreeWarp, object: Warpable): string | undefined {
  const { attributes } = object.geometry
  const { isInstancedMesh } = object as InstancedMesh
  if (!(object as Mesh).isMesh) return 'points and lines are not divided'
  if ((object as BatchedMesh).isBatchedMesh || isInstancedMesh2(object))
    return 'the geometries of a batch are not divided'
  if (hasPose(object) && warp.settings.space === 'rest')
    return "bones or morph targets move the warped surface in the space 'rest'"
  if (morphTextureOf(object)) return 'each instance has morph targets of its own'
  if ((object.geometry as InstancedBufferGeometry).isInstancedBufferGeometry)
    return 'an InstancedBufferGeometry is not divided'
  if (isInstancedMesh && warp.settings.space === 'world')
    return "in the space 'world' each instance has a surface of its own"
  if (!warp.runs)
    return 'the offset calls a glsl.fn or reads an image, which only the GPU can evaluate'
  for (const name of ['position', 'normal', 'uv'] as const)
    if ((name === 'position' || warp.reads(name)) && !attributes[name])
      return `its geometry lacks the attribute "${name}"`
  const whole = Object.entries(attributes).find(
    ([name, each]) => isWhole(each) && !(isSkinned(object) && isOfBones(name)),
  )
  return whole && `the attribute "${whole[0]}" consists of whole numbers`
}

/** Tests whether shaders read the attribute as whole numbers, between which there are none. */
const isWhole = (attribute: object) => (attribute as { gpuType?: number }).gpuType === IntType
