// The option `maxIterations` of all functions that read loops. It belongs to no front end, so that a bundle can have its kind alone.
import { wholeNumber } from './kinds.js'
import type { KindsOf } from './schema.js'

/** Equal to `maxIterationLimit` in loops.hpp. */
export const maxIterationLimit = 4096

/** `missing` is the value if the option is missing. */
export const maxIterationsKind = (missing: number) =>
  wholeNumber({ min: 1, max: maxIterationLimit, default: missing })

/** The option of functions that read shaders whose loops need no known end. */
export interface LoopOptions {
  /**
   * Max number of iterations, from 1 to 4096, of every loop whose end only the shader knows. A loop that goes on for longer is cut off
   * there, without a message. Nested loops of this kind multiply it, to at most 10,000. Default: such a loop runs until it ends. If it
   * cannot stay a loop in the shader, for example because it changes more than about 30 numbers, it is cut off after 256 iterations, and
   * a console warning says which loop that is.
   */
  maxIterations?: number
}

/** The value of `maxIterations` for loops that run until they end. Equal to `untilEnd` in loops.hpp. */
export const untilEnd = -1

export const loopKinds = {
  maxIterations: maxIterationsKind(untilEnd),
} satisfies KindsOf<LoopOptions>
