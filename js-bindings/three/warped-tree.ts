// The objects that one call of `warp` warps: an object, its descendants, their clones, and objects that are added later.
import { REVISION, type Material, type Mesh, type Object3D } from 'three'
import { variationAttribute, variationNames } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { noteApproximation } from '../errors/notes.js'
import { describeOfThree, nameOf } from './describe.js'
import { forgetBounds, warpPart, type Part } from './part.js'
import type { Warpable } from './pose.js'
import { wrapMethod } from './properties.js'
import { isWarped, share, unshare } from './registry.js'
import { attachToWebGPU, problemOf } from './renderers.js'
import type { Settings } from './settings.js'
import type { ThreeWarp } from './three-warp.js'
import { Variants } from './variants.js'

export class WarpedTree {
  readonly warp: ThreeWarp
  readonly parts: Part[] = []
  readonly skipped: Object3D[] = []
  private readonly variants: Variants
  /**
   * The parts of clones and of objects that were added later. Held weakly, since these objects may be collected before the warp is disposed
   * of.
   */
  private readonly later = new Set<WeakRef<Part>>()
  private readonly partOf = new WeakMap<Object3D, Part>()
  private readonly releases: (() => void)[] = []

  /** Throws, if at all, before it changes anything. */
  constructor(
    readonly root: Object3D,
    private readonly settings: Settings,
    createWarp: () => ThreeWarp,
  ) {
    const { method } = settings
    if (!root?.isObject3D)
      throw new WarpError(
        `${method}: expected a Mesh, Points, a Line or a group of them, got ${describeOfThree(root)}.`,
      )
    const drawn = drawnIn(root)
    if (!drawn.length)
      throw new WarpError(
        `${method}: there is nothing to draw in ${nameOf(root)}; add what is to be warped first.`,
      )
    for (const each of drawn) if (isWarped(each)) throw this.error(warpedAlready(each))
    const problems = drawn.map((each) => this.problemWithObject(each))
    const possible = drawn.filter((_, i) => !problems[i])
    if (!possible.length) throw this.error(problems[0]!)
    this.warp = createWarp()
    this.variants = new Variants(this.warp)
    for (const each of possible) {
      const problem = this.problemWithInputs(each)
      if (problem) throw this.error(problem)
    }
    this.warnOf(problems.filter((problem) => problem !== undefined))
    this.skipped.push(...drawn.filter((_, i) => problems[i]))
    for (const each of possible) this.parts.push(this.warpObject(each))
    this.watch(root)
    if (settings.isShared) this.shareMaterials()
  }

  dispose() {
    for (const release of this.releases.splice(0)) release()
    for (const part of this.later) part.deref()?.release()
    for (const part of this.parts.splice(0)) part.release()
    this.later.clear()
    this.variants.dispose()
  }

  private error(problem: string) {
    return new WarpError(`${this.settings.method}: ${problem}.`)
  }

  /** Warns of objects that cannot be warped, in one message. */
  private warnOf(problems: readonly string[]) {
    if (problems.length)
      console.warn(`${this.settings.method}: drawn without the warp: ${problems.join('; ')}.`)
  }

  private warpObject(object: Warpable): Part {
    const { warp } = this
    if (warp.varies && this.settings.surfaceVariation !== false && !hasVariation(object))
      noteApproximation(this.settings.method, 'await addSurfaceVariation(geometry)')
    const part = warpPart(this.variants, object, (clone) => {
      forgetBounds(clone)
      this.adopt(clone)
    })
    this.partOf.set(object, part)
    return part
  }

  /** Warps an object that was added or cloned later, with its descendants. */
  private adopt(object: Object3D) {
    const problems: string[] = []
    for (const each of drawnIn(object)) {
      if (isWarped(each)) continue
      const problem = this.problemWithObject(each) ?? this.problemWithInputs(each)
      if (problem) problems.push(problem)
      else this.later.add(new WeakRef(this.warpObject(each)))
    }
    this.warnOf(problems)
  }

  /** Adopts objects when they are added to an object or to one of its descendants. */
  private watch(object: Object3D) {
    const onChildAdded = (child: Object3D) => {
      this.adopt(child)
      child.traverse(listen)
    }
    const listen = (each: Object3D) => {
      const stop = onAdded(each, onChildAdded)
      this.releases.push(stop)
    }
    object.traverse(listen)
  }

  /** Warps the other objects that share a material with a part: those in the scene now, and others when they are drawn. */
  private shareMaterials() {
    const materials = new Set(this.parts.flatMap(({ object }) => [object.material].flat()))
    const adopt = (object: Object3D) => {
      this.adopt(object)
      return isWarped(object) ? this.variants : undefined
    }
    for (const material of materials) {
      share(material, adopt)
      this.releases.push(attachToWebGPU(material, this.warp), () => unshare(material))
    }
    let top = this.root
    while (top.parent) top = top.parent
    top.traverse((each) => {
      const { material } = each as Mesh
      if (material && [material].flat().some((one) => materials.has(one))) this.adopt(each)
    })
  }

  /** Describes why an object cannot be warped by any offset; `undefined` if it can. */
  private problemWithObject(object: Warpable): string | undefined {
    if ((object as { isSprite?: boolean }).isSprite)
      return `${nameOf(object)} always faces the camera and has no surface; use a Mesh with a PlaneGeometry`
    if (!object.geometry.attributes?.position)
      return `the geometry of ${nameOf(object)} has no attribute "position"`
    return ([object.material].flat() as Material[])
      .map((material) => problemOf(this.settings, material, object))
      .find((problem) => problem !== undefined)
  }

  /** Describes which attribute the offset reads and the geometry lacks; `undefined` if it lacks none. */
  private problemWithInputs(object: Warpable): string | undefined {
    const remedies = {
      normal: 'call geometry.computeVertexNormals() first',
      uv: 'give it texture coordinates first',
    }
    for (const name of ['normal', 'uv'] as const)
      if (this.warp.reads(name) && !object.geometry.attributes[name])
        return `the offset reads ${name}, but the geometry of ${nameOf(object)} has no attribute "${name}"; ${remedies[name]}`
    return undefined
  }
}

/** Calls `work` with each child that is added to an object; the returned function ends that. */
function onAdded(object: Object3D, work: (child: Object3D) => void): () => void {
  const weak = new WeakRef(object)
  // Three.js dispatches the event since 0.164.
  if (Number(REVISION) < 164) {
    const stop = wrapMethod<Object3D['add']>(object, 'add', (original) => {
      return function (this: Object3D, ...children) {
        original.apply(this, children)
        children.forEach(work)
        return this
      }
    })
    return () => weak.deref() && stop()
  }
  const listener = ({ child }: { child: Object3D }) => work(child)
  object.addEventListener('childadded', listener)
  return () => weak.deref()?.removeEventListener('childadded', listener)
}

const warpedAlready = (object: Object3D) =>
  `${nameOf(object)} is warped already, or a clone of a warped object; call dispose() of that warp first, or compose both offsets, as with chain of warpjet/deformers`

/** Returns those of an object and its descendants that three.js draws: the ones with a geometry and a material. */
function drawnIn(object: Object3D): Warpable[] {
  const drawn: Warpable[] = []
  object.traverse((each) => {
    const { geometry, material } = each as Mesh
    if (geometry && material) drawn.push(each as Warpable)
  })
  return drawn
}

const hasVariation = ({ geometry }: Warpable) =>
  variationNames.some((name) => variationAttribute(name) in geometry.attributes)
