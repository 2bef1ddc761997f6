// Reads the options of `warp` and `warpMaterial`.
import {
  normalsKinds,
  type NormalsOption,
  type UniformExpressions,
  type Vec3,
  type WarpInputs,
} from '../compile/hosts.js'
import { detailKind, type DetailOption, type DetailSettings } from '../detail/option.js'
import { WarpError } from '../errors/errors.js'
import { anything, boolean, kind, oneOf, optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import type { PlainOf, ThreeUniforms } from './uniforms.js'

/**
 * The space of `position`. `'local'`: the units of the geometry, after morph targets and bones, before the matrices of the
 * instance and the object. `'rest'`: the units of the geometry, before morph targets and bones. `'world'`: the units of the
 * scene, after all of these.
 */
export type WarpSpace = 'local' | 'rest' | 'world'

export interface WarpOptions<Uniforms extends object = ThreeUniforms> {
  /** @default 'local' */
  space?: WarpSpace
  /** The values that the offset function reads as `uniforms`: numbers, lists of numbers, vectors, colours, matrices or
   * textures of three.js, or functions that return one of them, called once per frame. */
  uniforms?: Uniforms
  /**
   * Normals are computed at each `'vertex'`, and interpolated by three.js, or exactly at each `'pixel'`. `'auto'` chooses
   * `'pixel'` for a warp that contains noise or bends strongly, unless that takes too many operations per pixel. Shaders that change
   * normals after the warp, or that do not use three.js' normals, always get normals of vertices.
   * @default 'auto'
   */
  normals?: 'auto' | 'vertex' | 'pixel'
  /**
   * If true, noise fades where its waves cover fewer than four pixels. If false, it keeps its full strength there, and noise that is finer
   * than a pixel sparkles. Normals at vertices are unaffected.
   * @default true
   */
  fadeNoise?: boolean
  /**
   * Draws meshes with as many triangles as needed for the drawn surface to be within this number of pixels of the true warped surface: a
   * number, or `'auto'`, which is 1, or 2 on devices that are used by touch. `{ tolerance: 1, curved: true }` also rounds coarse meshes.
   * `false` draws the vertices of the geometry. For `warp` only. With this option, bones and morph targets are applied on the CPU.
   * These keep their own vertices: batches, points and lines, meshes with bones or morph targets in the space `'rest'`, instances in the
   * space `'world'`, and all meshes outside of a `Scene`. For shadows, the number is in texels of their maps.
   * @default false
   */
  detail?: DetailOption
  /** `true` warps the material on every mesh that uses it. */
  share?: boolean
  /** `false` silences the warning that normal and uv are treated as constant over the surface. */
  surfaceVariation?: false
}

/** The inputs that only p5 has. */
type P5Input =
  'mouse' | 'mouseX' | 'mouseY' | 'size' | 'width' | 'height' | 'pixelDensity' | 'instance'

/** Maps a vertex to the offset that moves it. The inputs of the mouse, the canvas and `instance` exist in p5 only. */
export type ThreeOffset<Values = {}> = (
  inputs: Omit<WarpInputs, 'uniforms' | P5Input> & {
    uniforms: UniformExpressions<PlainOf<Values>>
  },
) => Vec3

export interface Settings {
  method: string
  space: WarpSpace
  /** True if the vertex is warped after the matrices of instances, although the space is 'local'. */
  isAfterInstances?: boolean
  uniforms: object | undefined
  normals: NormalsOption
  fadeNoise: boolean
  isShared: boolean
  detail?: DetailSettings | undefined
  surfaceVariation: false | undefined
}

const options = object({
  space: oneOf(['local', 'rest', 'world'], 'local'),
  uniforms: anything<object>(),
  ...normalsKinds,
  detail: detailKind,
  share: boolean(false),
  surfaceVariation: optional(
    kind<false>('only false', (given) => given === false, {
      advice: () => 'addSurfaceVariation(geometry) says how a geometry varies',
    }),
  ),
} satisfies KindsOf<WarpOptions<object>>)

export function readOptions(method: string, userOptions?: WarpOptions<object>): Settings {
  const { uniforms, share, ...others } = options.read(userOptions, new Place(method))
  if (others.detail !== undefined && method !== 'warp')
    throw new WarpError(
      `${method}: the option detail divides meshes, of which a material knows nothing; use warp(mesh, offset, { detail }).`,
    )
  return { method, ...others, uniforms: uniforms as never, isShared: share }
}
