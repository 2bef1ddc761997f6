/** Subdivides a p5.Geometry: a number of times, or as finely as a warp of `compileWarp` or `createWarp` needs. */
import { importMesh } from '#mesh'
import type { Evaluates } from '../../mesh/evaluates.js'
import type { AdaptiveOptions, LevelsOptions } from '../../mesh/subdivide.js'
import { madeWarpOf } from '../made-warps.js'
import { withOwnErrors } from '../page/own-errors.js'
import { inputsNow } from '../sketch-uniforms.js'
import { emptyModel } from './load-model.js'
import type { P5Constructors, WarpModel } from './model.js'

/** The function that createWarp returns. */
type CreatedWarp = (uniforms?: never) => void

/** The options of `subdivide` of 'warpjet/mesh', except that `warp` may also be a function that createWarp returned. */
export type SubdivideOptions =
  LevelsOptions | (Omit<AdaptiveOptions, 'warp'> & { warp: Evaluates | CreatedWarp })

/** Replaces a warp of createWarp by its CPU version, and adds the current inputs of the sketch to the uniforms. */
function withWarpOnCpu(options: AdaptiveOptions): AdaptiveOptions {
  const made = madeWarpOf(options.warp)
  if (!made) return options
  return {
    ...options,
    warp: made.warp.cpu(),
    uniforms: { ...inputsNow(made.canvas), ...options.uniforms } as AdaptiveOptions['uniforms'],
  }
}

/**
 * Returns a copy of a p5.Geometry with more vertices: a number n splits each triangle into four, n times; `{ warp, tolerance }` splits
 * triangles where the warp bends them. Throws a `WarpError` for a shape without triangles, and for wrong options.
 */
export const subdivideShape = (
  p5: P5Constructors,
  renderer: object | undefined,
  shape: unknown,
  options: number | SubdivideOptions,
): Promise<WarpModel> =>
  withOwnErrors(async () => {
    const { subdivideP5Model } = await importMesh('subdivide')
    const dense = emptyModel(p5, renderer)
    const passed = options as number | AdaptiveOptions | LevelsOptions
    const isAdaptive = typeof passed === 'object' && passed !== null && 'warp' in passed
    subdivideP5Model(dense, p5, shape, isAdaptive ? withWarpOnCpu(passed) : passed)
    return dense
  })
