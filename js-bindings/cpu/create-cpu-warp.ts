// Makes the methods of a warp on the CPU from its programs.
import { lazily } from '../core/module/lazily.js'
import { bounds } from './bounds.js'
import type { CpuWarp } from './cpu-warp.js'
import { evaluate, evaluateAt } from './evaluate.js'
import { foldover } from './foldover.js'
import { inverseAt } from './inverse-at.js'
import { isMirrored, mirrors } from './orientation.js'
import { warpProgram, type WarpProgram } from './warp-program.js'

export const createCpuWarp = (warp: WarpProgram): CpuWarp => ({
  [warpProgram]: {
    ...warp,
    isMirrored: (place, uniforms) => isMirrored(warp, place, uniforms),
    mirrors: lazily(() => mirrors(warp)),
  },
  evaluate: (mesh, options) => evaluate(warp, mesh, options),
  evaluateAt: (position, inputs) => evaluateAt(warp, position, inputs),
  inverseAt: (point, options) => inverseAt(warp, point, options),
  bounds: (box, options) => bounds(warp, box, options),
  foldover: (mesh, options) => foldover(warp, mesh, options),
})
