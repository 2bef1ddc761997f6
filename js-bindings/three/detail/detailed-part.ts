/** The option `detail` of `warp`: draws one object with as many triangles as its warped surface needs on the screen. */
import { Matrix3, type BufferGeometry, type Mesh } from 'three'
import { DetailedMesh, type DetailViews, type ToSpace } from '../../detail/detailed-mesh.js'
import { transformSamples } from '../../detail/transform.js'
import { warnOfDetail } from '../../detail/warnings.js'
import { nameOf } from '../describe.js'
import { isSkinned, poseState, type Warpable } from '../pose.js'
import { remembered } from '../remembered.js'
import { computeDivision } from '../renderers.js'
import type { ThreeWarp } from '../three-warp.js'
import { baseState } from './base-state.js'
import { baseOf, poseBase, type GeometryBase } from './base.js'
import type { ComputeDetail } from './compute.js'
import { DividedGeometry } from './divided-geometry.js'
import { drawnSurfaceOf, type DrawnSurface } from './drawn-surface.js'
import { hasPose, problemOf } from './problems.js'
import type { Render } from './render.js'
import { addToScene, sceneOf, type Divisible } from './scenes.js'
import { placeOf, viewsOf } from './views.js'

/** Returns the object with its own vertices, even while it is drawn with others. */
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
  /** Present if 'warpjet/three/webgpu' is imported. */
  readonly compute: ComputeDetail | undefined
}

export class DetailedPart implements Divisible {
  readonly undivided: Warpable
  /** The user's geometry, while the object has another one. */
  private own: BufferGeometry | undefined
  /** The geometry that the object has instead. */
  private exchanged: BufferGeometry | undefined
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

  /** Finds the scene that the object is in now, so that the object is divided when that scene is rendered. */
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
    this.views = views
    const geometry = this.geometryFor(this.divided, render)
    this.own = object.geometry
    object.geometry = this.exchanged = geometry
    // Bones have moved the divided vertices already, and morph targets are not in the geometry.
    if (isSkinned(object)) Object.assign(object, { isSkinnedMesh: false })
  }

  private geometryFor(divided: Divided, render: Render): BufferGeometry {
    const { mesh, drawn, compute } = divided
    const computed = compute?.geometryFor(render, this.views)
    if (computed) {
      drawn.dispose()
      return computed
    }
    this.updateMesh(divided)
    drawn.write(mesh)
    compute?.takeOver(render)
    return drawn.geometry
  }

  private updateMesh({ mesh, pose }: Divided) {
    const { warp, object, toWorld, views } = this
    const base = pose()
    mesh.update(warp.given, views, warp.settings.detail!.tolerance, toWorld, placeOf(warp, object))
    return base
  }

  /** Returns the surface as the views of the last frame would show it now; `undefined` if no frame has shown it divided. */
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
    // The user may have assigned another geometry meanwhile.
    if (this.object.geometry === this.exchanged) this.object.geometry = this.own
    this.own = this.exchanged = undefined
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
    this.divided?.compute?.dispose()
    this.divided = this.surface = undefined
    this.views = []
  }

  /** Starts anew with the present geometry. */
  private start() {
    const { warp, object } = this
    this.free()
    const problem = problemOf(warp, object)
    if (problem) return warnOfDetail(warp, warp.settings.method, nameOf(object), problem)
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
    const compute = hasPose(object)
      ? undefined
      : computeDivision({ warp, object, mesh, base, toWorld: this.toWorld })
    this.divided = { mesh, drawn, pose, compute }
    // Buffers are made anew if a disposed geometry is drawn again, as in three.js.
    const onDispose = () => {
      drawn.dispose()
      compute?.dispose()
    }
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

/** Returns a function that transforms samples into world space by the present matrix of the object. */
function toWorldOf(warp: ThreeWarp, object: Warpable): ToSpace {
  const readsNormals = warp.reads('normal')
  const covariant = new Matrix3()
  return ({ normals, ...others }, to) =>
    transformSamples(readsNormals && normals ? { ...others, normals } : others, to, {
      matrix: object.matrixWorld.elements,
      normalMatrix: covariant.getNormalMatrix(object.matrixWorld).elements,
      hasUnitNormals: true,
    })
}
