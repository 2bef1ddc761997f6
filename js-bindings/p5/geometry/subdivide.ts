/** `subdivide` of a p5.Geometry, by a number or by a warp: one of `compileWarp`, or what `createWarp` returned. */
import type { Uniforms } from '../../core/inputs/vertices.js'
import type { Evaluates } from '../../mesh/bake.js'
import type { Makers, WarpModel } from './model.js'
import type { AdaptiveOptions, LevelsOptions } from '../../mesh/subdivide.js'
import { emptyModel } from './load-model.js'
import { madeWarpOf, onCpu } from '../made-warps.js'
import { importMesh } from '#mesh'
import { withOwnErrors } from '../page/own-errors.js'
import { inputsNow } from '../sketch-uniforms.js'

/** What createWarp makes. */
type Distort = (uniforms?: never) => void

/** As `subdivide` of 'warpjet/mesh' takes them, where the function that createWarp returned will do too. */
export type SubdivideOptions =
  LevelsOptions | (Omit<AdaptiveOptions, 'warp'> & { warp: Evaluates | Distort })

/** As far as it is one of createWarp, with what the sketch's clock, mouse and canvas are now. */
function withWarpOnCpu(options: AdaptiveOptions): AdaptiveOptions {
  const made = madeWarpOf(options.warp)
  if (!made) return options
  return {
    ...options,
    warp: onCpu(made),
    uniforms: { ...inputsNow(made.canvas), ...options.uniforms } as Uniforms,
  }
}

/**
 * A p5.Geometry with more vertices: each triangle becomes four, so many times, or with `{ warp, tolerance }` where the warp bends.
 * The one that comes in stays as it is. Throws a `WarpError`.
 */
export const subdivideShape = (
  p5: Makers,
  renderer: object | undefined,
  shape: unknown,
  options: number | SubdivideOptions,
): Promise<WarpModel> =>
  withOwnErrors(async () => {
    const { subdivideP5Model } = await importMesh('subdivide')
    const dense = emptyModel(p5, renderer)
    const given = options as number | AdaptiveOptions | LevelsOptions
    const isByWarp = typeof given === 'object' && given !== null && 'warp' in given
    subdivideP5Model(dense, p5, shape, isByWarp ? withWarpOnCpu(given) : given)
    return dense
  })
