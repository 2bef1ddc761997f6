// What a `BabylonWarp` accepts: its options, and the materials that it can warp.
import type { Material } from '@babylonjs/core/Materials/material.js'
import {
  normalsKinds,
  type NormalsOption,
  type UniformOptions,
  type UniformValues,
} from '../compile/hosts.js'
import { describe } from '../errors/errors.js'
import { anything, kind, optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { pluginName } from './passes.js'

export const place = new Place('BabylonWarp')

export interface BabylonWarpOptions<Uniforms extends UniformValues = UniformValues> {
  /** The values that the offset function reads as `uniforms`: numbers, lists of numbers, `Vector3`s, textures, or functions
   * that return them. */
  uniforms?: UniformOptions<Uniforms>
  /**
   * Where normals are computed: at `'vertex'` and interpolated between vertices, or exactly at each `'pixel'`. `'auto'` selects `'pixel'`
   * for a warp that contains noise or bends strongly, unless that takes more than 4000 operations per pixel; see `normals` of the warp.
   * @default 'auto'
   */
  normals?: NormalsOption
  /**
   * `false` keeps the full strength of noise where its waves cover fewer than four pixels; noise that is finer than a pixel sparkles
   * then. Normals at vertices are unaffected.
   * @default true
   */
  fadeNoise?: boolean
  /**
   * `false` silences the warning about a mesh without `addSurfaceVariation`, where the shader treats normal and uv as constant over the
   * surface.
   */
  surfaceVariation?: false
}

export const optionsKind = object({
  uniforms: anything<UniformOptions<UniformValues>>(),
  ...normalsKinds,
  surfaceVariation: optional(
    kind<false>('only false', (given) => given === false, {
      advice: () => 'addSurfaceVariation(mesh) computes how a mesh varies',
    }),
  ),
} satisfies KindsOf<BabylonWarpOptions>)

/** Maps the class of a material that does not call plugins → what to do instead. */
const remedies: Partial<Record<string, string>> = {
  MultiMaterial: 'warp its subMaterials',
  NodeMaterial: 'use a StandardMaterial or a PBRMaterial',
  BackgroundMaterial: 'use a StandardMaterial or a PBRMaterial',
  ShaderMaterial: 'put the code of compileWarp into its shader',
}

/** Throws for a material that cannot be warped. */
export function rejectUnwarpable(material: Material) {
  if (typeof (material as Partial<Material>)?.getEffect !== 'function')
    throw place.expected('a material of Babylon.js', describe(material))
  const remedy = remedies[material.getClassName()]
  if (remedy)
    throw place.error(
      `the ${material.getClassName()} "${material.name}" takes no plugins; ${remedy}.`,
    )
  if (material.pluginManager?.getPlugin(pluginName))
    throw place.error(
      `the material "${material.name}" is warped already; set isEnabled of that warp to false and warp a clone of the material, or combine both offsets into one, such as by chain of warpjet/deformers.`,
    )
}
