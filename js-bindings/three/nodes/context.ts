/**
 * The one place where WebGPURenderer meets a warp. Every draw of an object, whichever pass and material it is for, goes through
 * `renderObject`, and every material builds its vertex in `setupPosition`. So `renderObject` puts the warp of the object into
 * the renderer's `contextNode` while the object is drawn, and `setupPosition` takes it from there. The id of the context is a
 * part of three's cache key, so that no other object, even of the same geometry and material, gets the warped shader.
 *
 * The methods are replaced on the prototypes, once: an object's `onBeforeRender` is called when `render` has read
 * `renderObject` already, so that a renderer replaced there would draw its first frame without.
 */
import type { Material, Object3D } from 'three'
import * as TSL from 'three/tsl'
import { NodeMaterial, Renderer } from 'three/webgpu'
import type { ThreeWarp } from '../three-warp.js'
import type { Builder } from './builder.js'
import { exactOf } from './exact-normals/exact-node-materials.js'
import { displaceExactly } from './exact-normals/setup-exact.js'
import { withoutPositionNode } from './instances.js'
import type { AnyNode } from './tsl.js'
import { setupWarped } from './vertex.js'

/** Maps what is warped, an object or a material on all objects, → its warp. */
const warps = new WeakMap<object, ThreeWarp>()

/** Maps nodes of `warpNode` → their warps. */
const warpsOfNodes = new WeakMap<AnyNode, ThreeWarp>()

/** Draws an object, or all that has a material, warped from now on; call the result to end that. */
export function carry(target: Object3D | Material, warp: ThreeWarp): () => void {
  warps.set(target, warp)
  return () => void (warps.get(target) === warp && warps.delete(target))
}

/** Makes the node stand for the warp where it is a whole `positionNode`. */
export function markNode(node: AnyNode, warp: ThreeWarp): AnyNode {
  warpsOfNodes.set(node, warp)
  return node
}

/** Tests whether a renderer is of the copy of three.js whose methods are replaced here. */
export const isOurs = (renderer: unknown): boolean => renderer instanceof Renderer

interface ContextNode {
  version: number
}

interface WarpContext {
  node: ContextNode
  outer: ContextNode
  version: number
}

/** Maps our context → the one around it. */
const outerOf = new WeakMap<ContextNode, ContextNode>()
const contexts = new WeakMap<ThreeWarp, WeakMap<ContextNode, WarpContext>>()

/** Returns the context for an object with this warp, or with none: shadows are drawn while another object is. */
function contextFor(current: ContextNode, warp: ThreeWarp | undefined): ContextNode {
  const outer = outerOf.get(current) ?? current
  if (!warp) return outer
  let byOuter = contexts.get(warp)
  if (!byOuter) contexts.set(warp, (byOuter = new WeakMap()))
  const known = byOuter.get(outer)
  if (known?.version === outer.version) return known.node
  const node = TSL.context(outer as never, { warpjet: warp }) as unknown as ContextNode
  byOuter.set(outer, { node, outer, version: outer.version })
  outerOf.set(node, outer)
  return node
}

interface Drawing {
  contextNode: ContextNode
}

/** The methods of NodeMaterial that are replaced, and what they use. */
interface Methods {
  positionNode: unknown
  setupNormal(builder: Builder): unknown
  setupPosition(builder: Builder): unknown
  setupPositionView(builder: Builder): unknown
  setupObserver(builder: Builder): { hasNode: boolean }
  customProgramCacheKey(): string
}

let isInstalled = false

export function install() {
  if (isInstalled) return
  isInstalled = true
  installInRenderer(Renderer.prototype as never)
  installInMaterials(NodeMaterial.prototype as never)
}

type RenderObject = (
  this: Drawing,
  object: Object3D,
  scene: unknown,
  camera: unknown,
  geometry: unknown,
  material: Material,
  ...others: unknown[]
) => void

function installInRenderer(prototype: { renderObject: RenderObject }) {
  const { renderObject } = prototype
  prototype.renderObject = function (object, scene, camera, geometry, material, ...others) {
    const before = this.contextNode
    this.contextNode = contextFor(before, warps.get(object) ?? warps.get(material))
    try {
      renderObject.call(this, object, scene, camera, geometry, material, ...others)
    } finally {
      this.contextNode = before
    }
  }
}

function installInMaterials(prototype: Methods) {
  const { setupPosition, setupObserver, setupPositionView, customProgramCacheKey } = prototype
  prototype.customProgramCacheKey = function () {
    const key = customProgramCacheKey.call(this)
    const exact = exactOf(this)
    return exact ? `${key} ${exact.key}` : key
  }
  prototype.setupPosition = function (builder) {
    const { warpjet } = builder.context as { warpjet?: ThreeWarp }
    const nodeWarp = warpsOfNodes.get(this.positionNode as AnyNode)
    const warp = warpjet ?? nodeWarp
    const exact = nodeWarp ? undefined : exactOf(this)
    if (!warp && !exact) return setupPosition.call(this, builder)
    const positionNode = this.positionNode as AnyNode
    const setup = () => void setupPosition.call(this, builder)
    const setupPlain = () => withoutPositionNode(this, setup)
    if (warp && exact)
      setupWarped(warp, builder, this, setupPlain, () =>
        displaceExactly(exact, builder, this, positionNode, warp),
      )
    else if (exact) {
      setupPlain()
      displaceExactly(exact, builder, this, positionNode)
    } else if (nodeWarp) withoutPositionNode(this, () => setupWarped(warp!, builder, this, setup))
    else setupWarped(warp!, builder, this, setup)
    // That of PointsNodeMaterial has the positionNode itself there.
    builder.context.setupPositionView = () => setupPositionView.call(this, builder)
    return TSL.positionLocal
  }
  // Three.js sends the uniforms of a material without nodes only when they change, and does not know those of a warp.
  prototype.setupObserver = function (builder) {
    const observer = setupObserver.call(this, builder)
    if (builder.context.warpjet) observer.hasNode = true
    return observer
  }
}
