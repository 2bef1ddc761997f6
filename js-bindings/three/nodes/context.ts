/**
 * Connects warps with WebGPURenderer. Every draw of an object, whichever pass and material it is for, goes through
 * `renderObject`, and every material builds its vertex in `setupPosition`. So our `renderObject` puts the warp of the object into
 * the renderer's `contextNode` while the object is drawn, and our `setupPosition` reads it there. The id of the context is a
 * part of three's cache key, so that no other object, even of the same geometry and material, gets the warped shader.
 *
 * We replace the methods on the prototypes, once. An object's `onBeforeRender` would be too late to replace them on its renderer: by
 * then `render` has read `renderObject`, so the first frame would be drawn without the warp.
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

/** Maps warped objects, and materials that are warped on all objects, → their warps. */
const warps = new WeakMap<object, ThreeWarp>()

/** Maps nodes of `warpNode` → their warps. */
const warpsOfNodes = new WeakMap<AnyNode, ThreeWarp>()

/** Makes the renderer warp an object, or all objects that have a material; the returned function ends that. */
export function attachWarp(target: Object3D | Material, warp: ThreeWarp): () => void {
  warps.set(target, warp)
  return () => void (warps.get(target) === warp && warps.delete(target))
}

/** Marks a node. A material that has this node as its whole `positionNode` gets the warp, with the warp's normals. */
export function markNode(node: AnyNode, warp: ThreeWarp): AnyNode {
  warpsOfNodes.set(node, warp)
  return node
}

/** Tests whether a renderer belongs to the copy of three.js whose methods are replaced here. */
export const isOurs = (renderer: unknown): boolean => renderer instanceof Renderer

interface ContextNode {
  version: number
}

interface WarpContext {
  node: ContextNode
  outer: ContextNode
  version: number
}

/** Maps our contexts → the contexts around them. */
const outerOf = new WeakMap<ContextNode, ContextNode>()
const contexts = new WeakMap<ThreeWarp, WeakMap<ContextNode, WarpContext>>()

/**
 * Returns the context for an object with this warp, or without any. `current` can be the context of another object, since shadows are
 * rendered while that object is drawn.
 */
function contextFor(current: ContextNode, warp: ThreeWarp | undefined): ContextNode {
  const outer = outerOf.get(current) ?? current
  if (!warp) return outer
  let byOuter = contexts.get(warp)
  if (!byOuter) contexts.set(warp, (byOuter = new WeakMap()))
  const cached = byOuter.get(outer)
  if (cached?.version === outer.version) return cached.node
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
    // PointsNodeMaterial's own method would read the positionNode again, without the warp.
    builder.context.setupPositionView = () => setupPositionView.call(this, builder)
    return TSL.positionLocal
  }
  // Three.js sends the uniforms of a material without nodes only when it sees a change, and it does not know the uniforms of a warp.
  prototype.setupObserver = function (builder) {
    const observer = setupObserver.call(this, builder)
    if (builder.context.warpjet) observer.hasNode = true
    return observer
  }
}
