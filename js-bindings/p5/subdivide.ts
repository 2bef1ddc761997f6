/** `subdivide` of a p5.Geometry, by a number or by a warp: one of `compileWarp`, or what `createWarp` returned. */
import { runOnCpu } from '../compile/compile-warp.js'
import type { KeptWarp } from '../compile/warp-text.js'
import type { Uniforms } from '../inputs/vertices.js'
import type { Evaluates } from '../mesh/bake.js'
import type { Makers, WarpModel } from '../mesh/p5-model.js'
import type { AdaptiveOptions, LevelsOptions } from '../mesh/subdivide.js'
import type { Canvas } from './host.js'
import { emptyModel } from './load-model.js'
import { importMesh } from './mesh-module.js'
import { withOwnErrors } from './own-errors.js'
import type { WarpSettings } from './settings.js'
import { inputsNow } from './sketch-uniforms.js'

/** What createWarp makes. */
type Distort = (uniforms?: never) => void

interface Made {
  canvas: Canvas
  warp: KeptWarp
  settings: WarpSettings
}

const made = new WeakMap<object, Made>()

/** The function that a sketch gets, for `subdivide` to know again. */
export function remember<Function extends object>(distort: Function, how: Made): Function {
  made.set(distort, how)
  return distort
}

/** As `subdivide` of 'warpjet/mesh' takes them, where the function that createWarp returned will do too. */
export type SubdivideOptions =
  LevelsOptions | (Omit<AdaptiveOptions, 'warp'> & { warp: Evaluates | Distort })

/** As far as it is one of createWarp, with what the sketch's clock, mouse and canvas are now. */
function onCpu({ warp, uniforms, ...others }: AdaptiveOptions): AdaptiveOptions {
  const how = made.get(warp)
  if (!how) return { warp, uniforms, ...others }
  const { canvas, settings } = how
  const names = new Map([...settings.labels].map(([name, label]) => [label, name]))
  const nameOf = (label: string) => names.get(label) ?? label
  return {
    warp: runOnCpu(how.warp, settings.uniforms, 'position', nameOf),
    uniforms: { ...inputsNow(canvas), ...uniforms } as Uniforms,
    ...others,
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
    subdivideP5Model(dense, p5, shape, isByWarp ? onCpu(given) : given)
    return dense
  })
