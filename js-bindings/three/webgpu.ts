// `warpMaterial` and `warpNode` for WebGPURenderer, on WebGPU and on WebGL 2, and what `warp` needs for it.
import type { Material } from 'three'
import type { Node } from 'three/webgpu'
import { WarpError } from '../errors/errors.js'
import { spriteError } from './describe.js'
import { type ThreeWarp, keep } from './kept.js'
import {
  type Warped,
  type Woven,
  checkMaterial as checkOfWebGL,
  checkUnwarped,
  mark,
  updateOf,
} from './material.js'
import { nodeFor, obstacle } from './nodes.js'
import { type ThreeOffset, type WarpOptions, readOptions } from './settings.js'
import type { ThreeUniforms, ValuesOf } from './uniforms.js'
import { provideNodes } from './renderers.js'

/** The properties of a material of nodes that have the vertex, also on others, of which three.js makes such. */
interface NodeMaterial extends Material {
  isNodeMaterial?: boolean
  positionNode?: unknown
  castShadowPositionNode?: unknown
  vertexNode?: unknown
}

function checkMaterial(method: string, material: unknown): asserts material is Material {
  const { isNodeMaterial, vertexNode, type } = (material ?? {}) as NodeMaterial
  if (!isNodeMaterial) checkOfWebGL(method, material)
  else checkUnwarped(method, material as Material)
  const { isShaderMaterial } = material as { isShaderMaterial?: boolean }
  if (isShaderMaterial)
    throw new WarpError(
      `${method}: WebGPURenderer does not draw a ${type}; use a material of nodes.`,
    )
  if ((material as { isSpriteNodeMaterial?: boolean }).isSpriteNodeMaterial)
    throw spriteError(method, 'a sprite')
  if (vertexNode)
    throw new WarpError(
      `${method}: the material's vertexNode replaces the place of the vertex, so that a warp would do nothing; put it into positionNode.`,
    )
}

function weaveInto(
  given: Material,
  warp: ThreeWarp,
  made = warp.settings.isShared ? given : given.clone(),
): Woven {
  const { isShared } = warp.settings
  const material = made as NodeMaterial
  const { positionNode, castShadowPositionNode } = given as NodeMaterial
  const had = Object.hasOwn(material, 'positionNode')
  material.positionNode = nodeFor(warp, positionNode ?? undefined)
  if (castShadowPositionNode)
    material.castShadowPositionNode = nodeFor(warp, castShadowPositionNode)
  material.needsUpdate = true
  mark(material, true)
  return {
    material,
    restore() {
      if (!isShared) return material.dispose()
      mark(material, false)
      if (had) material.positionNode = positionNode
      else delete material.positionNode
      if (castShadowPositionNode) material.castShadowPositionNode = castShadowPositionNode
      material.needsUpdate = true
    },
  }
}

provideNodes({ check: checkMaterial, obstacle, weave: weaveInto })

export interface NodeWarpedMaterial<
  Kind extends Material = Material,
  Uniforms = {},
> extends Warped<Uniforms> {
  /** A clone of the material, warped; with `share: true` the material itself. */
  readonly material: Kind
}

/** A material whose vertices a warp moves and whose normals it turns, with its shadows. */
export function warpMaterial<Kind extends Material, const Uniforms extends ThreeUniforms = {}>(
  material: Kind,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): NodeWarpedMaterial<Kind, ValuesOf<Uniforms>> {
  const method = 'warpMaterial'
  const settings = readOptions(method, options)
  checkMaterial(method, material)
  const warp = keep(offset as never, settings)
  const woven = weaveInto(material, warp)
  return {
    material: woven.material as Kind,
    uniforms: warp.handles as never,
    update: updateOf(warp),
    dispose: woven.restore,
  }
}

export interface WarpNode<Uniforms = {}> extends Omit<Warped<Uniforms>, 'dispose'> {
  /** For `positionNode` of any material of nodes; it turns `normalLocal` and `tangentLocal` too. */
  readonly node: Node
}

/** The warp as a node: `material.positionNode = warpNode(offset).node`. */
export function warpNode<const Uniforms extends ThreeUniforms = {}>(
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpNode<ValuesOf<Uniforms>> {
  const warp = keep(offset as never, readOptions('warpNode', options))
  return {
    node: nodeFor(warp) as unknown as Node,
    uniforms: warp.handles as never,
    update: updateOf(warp),
  }
}
