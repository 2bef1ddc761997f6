// Whole numbers of 32 bits, of which a float tells only 24: as two halves of 16, of which the builder makes them again.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'

/** What stands for whole numbers that may be large: their lower 16 bits, and the rest with its sign. */
export class Halves {
  constructor(
    readonly low: Expression,
    readonly high: Expression,
  ) {}
}

/** The columns of a matrix that is not square, which no expression can be. */
export class Columns {
  constructor(readonly vectors: readonly Expression[]) {}
}

/** A float will do where numbers are known to be small. */
export type Given = Expression | Halves | Columns

/** The half that is asked for; there is no upper one of a float. */
export function halfOf(given: Expression | Halves, isHigh: boolean): Expression | undefined {
  if (given instanceof Halves) return isHigh ? given.high : given.low
  return isHigh ? undefined : given
}

/** A number that is an int or uint, of a sketch or of a text. */
export function halvesOf(glsl: Builder, value: number): Expression | Halves {
  if (Math.abs(value) <= 2 ** 24) return glsl.val!(value)
  const bits = Math.trunc(value) | 0
  return new Halves(glsl.val!(bits & 0xffff), glsl.val!(bits >> 16))
}

/** The whole number itself, by operations on bits, which GLSL 1.00 is refused: its numbers need not have so many. */
export const wholeOf = (glsl: Builder, low: Expression, high: Expression): Expression =>
  glsl.bitOr!(glsl.shiftLeft!(glsl.int!(high), glsl.int!(glsl.val!(16))), glsl.int!(low))
