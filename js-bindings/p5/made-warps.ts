/** The recorded warp and the settings of each function that createWarp returned. */
import type { HostWarp } from '../compile/hosts.js'
import type { Canvas } from './host.js'
import type { WarpSettings } from './settings.js'

export interface MadeWarp {
  canvas: Canvas
  warp: HostWarp
  settings: WarpSettings
}

const madeWarps = new WeakMap<object, MadeWarp>()

export function rememberWarp<Function extends object>(distort: Function, made: MadeWarp): Function {
  madeWarps.set(distort, made)
  return distort
}

/** Returns the warp of a function that createWarp returned; `undefined` for any other value. */
export const madeWarpOf = (value: unknown): MadeWarp | undefined =>
  typeof value === 'function' ? madeWarps.get(value) : undefined
