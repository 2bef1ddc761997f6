// `warpMaterial` and `warpNode` for WebGPURenderer, on WebGPU and on WebGL 2, and what `warp` needs for it.
import type { Material, Mesh } from 'three'
import type { Node } from 'three/webgpu'
import { WarpError } from '../errors/errors.js'
import { nameOf, spriteError } from './describe.js'
import {
  checkMaterial as checkForWebGL,
  checkUnwarped,
  mark,
  updateOf,
  type Warped,
} from './material.js'
import { ComputedMesh } from './nodes/computed-mesh.js'
import { attachWarp, install, isOurs, markNode } from './nodes/context.js'
import { warmUpWhenIdle } from './nodes/exact-normals/warm-up.js'
import { nodeFor } from './nodes/vertex.js'
import { provideNodes } from './renderers.js'
import { readOptions, type ThreeOffset, type WarpOptions } from './settings.js'
import { ThreeWarp } from './three-warp.js'
import type { ThreeUniforms, ValuesOf } from './uniforms.js'

/** The properties of a NodeMaterial that we read. Three.js copies these flags when it converts another material to a NodeMaterial. */
interface NodeMaterial extends Material {
  isNodeMaterial?: boolean
  isShaderMaterial?: boolean
  isSpriteNodeMaterial?: boolean
  isPointsNodeMaterial?: boolean
  vertexNode?: unknown
}

/** Throws for a material that cannot be warped; `object` is the object that has it, if known. */
function checkMaterial(
  method: string,
  material: unknown,
  object?: Mesh,
): asserts material is Material {
  const { isNodeMaterial, vertexNode, type, ...is } = (material ?? {}) as NodeMaterial
  if (!isNodeMaterial) checkForWebGL(method, material)
  else checkUnwarped(method, material as Material)
  const name = nameOfMaterial(material as Material, object)
  if (is.isShaderMaterial)
    throw new WarpError(
      `${method}: WebGPURenderer does not draw ${name}; use a node material, such as MeshStandardNodeMaterial.`,
    )
  const isPoints =
    is.isPointsNodeMaterial && (object as { isPoints?: boolean } | undefined)?.isPoints
  if (is.isPointsNodeMaterial && object && !isPoints)
    throw new WarpError(
      `${method}: ${name} draws squares that face the camera, unless its object is a Points; use new Points(geometry, material).`,
    )
  if (is.isSpriteNodeMaterial && !is.isPointsNodeMaterial) throw spriteError(method, 'a sprite')
  if (vertexNode)
    throw new WarpError(
      `${method}: the vertexNode of ${name} replaces the position of the vertex, so that a warp would do nothing; move that node to positionNode.`,
    )
}

function nameOfMaterial({ name, type }: Material, object?: Mesh) {
  const material = name ? `the ${type} "${name}"` : object ? `the ${type}` : `this ${type}`
  return object ? `${material} of ${nameOf(object)}` : material
}

/** Warps a material on all objects that have it; the returned function ends that. */
function attachToMaterial(material: Material, warp: ThreeWarp) {
  const release = attachWarp(material, warp)
  mark(material, true)
  material.needsUpdate = true
  return () => {
    release()
    mark(material, false)
    material.needsUpdate = true
  }
}

install()
provideNodes({
  check: checkMaterial,
  attachWarp,
  isOurs,
  computeDivision: (input) => new ComputedMesh(input),
})
warmUpWhenIdle()

export interface NodeWarpedMaterial<
  Kind extends Material = Material,
  Uniforms = {},
> extends Warped<Uniforms> {
  /** A clone of the material, warped; with `share: true` the material itself. */
  readonly material: Kind
}

/** Warps a clone of the material, or with `share: true` the material itself: vertices, normals and shadows of every object that has it. */
export function warpMaterial<Kind extends Material, const Uniforms extends ThreeUniforms = {}>(
  material: Kind,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): NodeWarpedMaterial<Kind, ValuesOf<Uniforms>> {
  const method = 'warpMaterial'
  const settings = readOptions(method, options)
  checkMaterial(method, material)
  const warp = new ThreeWarp(offset as never, settings)
  const { isShared } = settings
  const warped = isShared ? material : material.clone()
  const release = attachToMaterial(warped, warp)
  return {
    material: warped as Kind,
    uniforms: warp.handles as never,
    normals: warp.normals,
    update: updateOf(warp),
    dispose() {
      release()
      if (!isShared) warped.dispose()
    },
  }
}

export interface WarpNode<Uniforms = {}> extends Omit<Warped<Uniforms>, 'dispose'> {
  /** A node for the `positionNode` of any node material; it transforms `normalLocal` and `tangentLocal`, too. */
  readonly node: Node
}

/** Makes a node of a warp: `material.positionNode = warpNode(offset).node`. */
export function warpNode<const Uniforms extends ThreeUniforms = {}>(
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpNode<ValuesOf<Uniforms>> {
  const warp = new ThreeWarp(offset as never, readOptions('warpNode', options))
  return {
    node: markNode(nodeFor(warp), warp) as unknown as Node,
    uniforms: warp.handles as never,
    normals: warp.normals,
    update: updateOf(warp),
  }
}
