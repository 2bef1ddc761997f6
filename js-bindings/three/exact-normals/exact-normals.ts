// `exactNormals`: exact normals for materials of WebGLRenderer whose vertex shaders already move vertices.
import type { Material, Mesh } from 'three'
import { normalsKinds } from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import { loopKinds, type LoopOptions } from '../../options/iterations.js'
import { kind, optional } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { object, type KindsOf } from '../../options/schema.js'
import { describeOfThree, nameOfMaterial } from '../describe.js'
import { isWarpedMaterial } from '../supported.js'
import type { ExactSettings } from './displacement.js'
import { exactMaterial } from './exact-material.js'
import { followDisplacement } from './follow.js'

export interface ExactNormalsOptions extends LoopOptions {
  /**
   * Normals are computed at each `'vertex'`, and interpolated by three.js, or exactly at each `'pixel'`. `'auto'` chooses
   * `'pixel'` for a displacement that contains noise or bends strongly, unless that takes too many operations per pixel.
   * @default 'auto'
   */
  normals?: 'auto' | 'vertex' | 'pixel'
  /** `false` silences the warning that an attribute of vertices is treated as constant over the surface. */
  surfaceVariation?: false
}

const optionKinds = object({
  normals: normalsKinds.normals,
  surfaceVariation: optional(
    kind<false>('only false', (target) => target === false, {
      advice: () => 'addSurfaceVariation(geometry) says how a geometry varies',
    }),
  ),
  maxIterations: loopKinds.maxIterations,
} satisfies KindsOf<ExactNormalsOptions>)

/**
 * Gives a material correct normals where its own vertex shader moves vertices: by `onBeforeCompile`, as a `ShaderMaterial` or
 * `RawShaderMaterial`, or by three-custom-shader-material. When three.js compiles the shader, we read and differentiate it, and transform
 * its normals and tangents by the exact derivative, in place of any normals that the shader computes by itself. Returns its first argument.
 *
 * With a mesh, its shadows, culling and rays follow the displacement, too.
 *
 * A loop whose end only the shader knows runs until it ends. If it cannot stay a loop in the shader, its normals are those of 256
 * iterations, and a console warning says which loop that is. The option `maxIterations` limits every such loop and silences the warning.
 *
 * A shader that cannot be read stays as it is, with one message on the console. Throws a `WarpError` for anything but a material or a
 * mesh, for materials of sprites, lines, points and nodes, and for a material that `warpMaterial` has warped. Other materials without
 * normals stay as they are.
 *
 * ```js
 * material.onBeforeCompile = (shader) => {
 *   shader.vertexShader = shader.vertexShader.replace('#include <begin_vertex>', `
 *     #include <begin_vertex>
 *     transformed.y += 0.2 * sin(4.0 * position.x);`)
 * }
 * exactNormals(material)
 * ```
 */
export function exactNormals<Given extends Material | Mesh>(
  target: Given,
  options: ExactNormalsOptions = {},
): Given {
  const method = 'exactNormals'
  const settings = { method, ...optionKinds.read(options, new Place(method)) } as ExactSettings
  const mesh = (target as Partial<Mesh> | undefined)?.isMesh ? (target as Mesh) : undefined
  if (!mesh && !(target as Partial<Material> | undefined)?.isMaterial)
    throw new WarpError(
      `${method}: expected a material or a Mesh of three.js, got ${describeOfThree(target)}.`,
    )
  const materials = mesh ? [mesh.material].flat() : [target as Material]
  for (const material of materials) rejectMaterial(method, material)
  for (const material of materials) exactMaterial(material, settings)
  if (mesh) followDisplacement(mesh, method)
  return target
}

type Flags = Partial<
  Record<
    | 'isNodeMaterial'
    | 'isSpriteMaterial'
    | 'isLineBasicMaterial'
    | 'isPointsMaterial'
    | 'isLineMaterial',
    boolean
  >
>

/** Throws for a material that has no normals, or none that WebGLRenderer draws. */
function rejectMaterial(method: string, material: Material) {
  const flags = material as Material & Flags
  const problem = flags.isNodeMaterial
    ? "is a node material, which only WebGPURenderer draws; import exactNormals from 'warpjet/three/webgpu'"
    : flags.isSpriteMaterial ||
        flags.isLineBasicMaterial ||
        flags.isPointsMaterial ||
        flags.isLineMaterial
      ? 'has no normals'
      : isWarpedMaterial(material)
        ? 'is warped by warpMaterial; call exactNormals first'
        : undefined
  if (problem) throw new WarpError(`${method}: ${nameOfMaterial(material)} ${problem}.`)
}
