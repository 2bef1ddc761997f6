// `exactNormals` for node materials.
import type { Material } from 'three'
import type { NodeMaterial } from 'three/webgpu'
import { normalsKinds, type NormalsOption } from '../../../compile/hosts.js'
import { loopKinds, type LoopOptions } from '../../../options/iterations.js'
import { Place } from '../../../options/place.js'
import { object, type KindsOf } from '../../../options/schema.js'
import { describeOfThree } from '../../describe.js'
import { addExact } from './exact-node-materials.js'
import type { ExactNodeSettings } from './exact-warp.js'

export interface ExactNormalsOptions extends LoopOptions {
  /**
   * Normals are computed at each `'vertex'`, and interpolated by three.js, or exactly at each `'pixel'`. `'auto'` chooses
   * `'pixel'` for a position that contains noise or bends strongly, unless that takes too many operations per pixel.
   * @default 'auto'
   */
  normals?: NormalsOption
}

const place = new Place('exactNormals')
const optionsKind = object({
  normals: normalsKinds.normals,
  maxIterations: loopKinds.maxIterations,
} satisfies KindsOf<ExactNormalsOptions>)

/** Returns settings for the warp that is read from a positionNode. */
export const settingsWith = (normals: NormalsOption, maxIterations: number): ExactNodeSettings => ({
  method: place.method,
  space: 'local',
  isAfterInstances: true,
  uniforms: undefined,
  normals,
  // Noise comes from the node, whose code we leave as it is.
  fadeNoise: false,
  isShared: true,
  surfaceVariation: undefined,
  maxIterations,
})

/**
 * Makes the normals, tangents and velocities of a material follow its `positionNode`: `exactNormals(material)`. We read the position from
 * the shader code that three.js writes for the node, on WebGPU and on WebGL 2, and differentiate it. The material's `normalNode` and
 * normal maps are applied to the new normals.
 *
 * A loop whose end only the shader knows runs until it ends. If it cannot stay a loop in the shader, it is cut off after 256 iterations,
 * position and normal, and a console warning says which loop that is. The option `maxIterations` limits every such loop and silences the
 * warning.
 *
 * Returns the material. Throws a `WarpError` unless it is a node material with a `positionNode` and without a `vertexNode`. If the position
 * cannot be differentiated, for example because it depends on `vertexIndex`, the material keeps its normals, and a console warning gives
 * the reason when it is first drawn.
 */
export function exactNormals<Kind extends Material>(
  material: Kind,
  options?: ExactNormalsOptions,
): Kind {
  const { isNodeMaterial, positionNode, vertexNode } = (material ?? {}) as Partial<
    Pick<NodeMaterial, 'isNodeMaterial' | 'positionNode' | 'vertexNode'>
  >
  if (!isNodeMaterial)
    throw place
      .part('the material')
      .expected('a node material, such as a MeshStandardNodeMaterial,', describeOfThree(material))
  if (vertexNode)
    throw place.error(
      'expected a material that moves its vertices by positionNode, got one with a vertexNode, which replaces the position.',
    )
  if (!positionNode)
    throw place.expected('a material with a positionNode', 'one without', 'set positionNode before')
  const { normals, maxIterations } = optionsKind.read(options, place)
  addExact(material, settingsWith(normals, maxIterations))
  material.needsUpdate = true
  return material
}
