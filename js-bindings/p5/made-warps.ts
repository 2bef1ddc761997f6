/** The recorded warp and the settings of each function that createWarp returned. */
import type { HostWarp } from '../compile/hosts.js'
import type { Canvas } from './host.js'
import type { WarpSettings } from './settings.js'

export interface MadeWarp {
  canvas: Canvas
  warp: HostWarp
  settings: WarpSettings
}

const made = new WeakMap<object, MadeWarp>()

export function rememberWarp<Function extends object>(distort: Function, how: MadeWarp): Function {
  made.set(distort, how)
  return distort
}

/** Returns `undefined` for any other value. */
export const madeWarpOf = (value: unknown): MadeWarp | undefined =>
  typeof value === 'function' ? made.get(value) : undefined
