// The option `maxIterations` of all functions that read loops. It belongs to no front end, so that a bundle can have its kind alone.
import { wholeNumber } from './kinds.js'
import type { KindsOf } from './schema.js'

export const maxIterationLimit = 4096

export const maxIterationsOr = (missing: number) =>
  wholeNumber({ min: 1, max: maxIterationLimit, default: missing })

/** The option of functions that read shaders whose loops need no known end. */
export interface LoopOptions {
  /**
   * Max number of iterations, from 1 to 4096, of a loop whose end only the shader knows. Default: such a loop runs until it ends. If it
   * cannot stay a loop in the shader, for example because it changes more than 32 numbers, it is cut off after 256 iterations, and a
   * console warning says which loop that is.
   */
  maxIterations?: number
}

/** The value of `maxIterations` for loops that run until they end. Equal to `untilEnd` in loops.hpp. */
export const untilEnd = -1

export const loopKinds = { maxIterations: maxIterationsOr(untilEnd) } satisfies KindsOf<LoopOptions>
