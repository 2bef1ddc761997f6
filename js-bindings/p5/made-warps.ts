/** The recorded warp and the settings of each function that createWarp returned. */
import type { KeptWarp } from '../compile/warp-text.js'
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { runOnCpu } from '../compile/compile-warp.js'
import type { Canvas } from './host.js'
import type { WarpSettings } from './settings.js'

export interface MadeWarp {
  canvas: Canvas
  warp: KeptWarp
  settings: WarpSettings
}

const made = new WeakMap<object, MadeWarp>()

export function rememberWarp<Function extends object>(distort: Function, how: MadeWarp): Function {
  made.set(distort, how)
  return distort
}

/** Undefined of everything else. */
export const madeWarpOf = (value: unknown): MadeWarp | undefined =>
  typeof value === 'function' ? made.get(value) : undefined

/** The warp on the CPU, under the names that the sketch gave its uniforms. */
export function onCpu({ warp, settings }: Omit<MadeWarp, 'canvas'>): CpuWarp {
  const names = new Map([...settings.labels].map(([name, label]) => [label, name]))
  return runOnCpu(warp, settings.uniforms, 'position', (label) => names.get(label) ?? label)
}
