// Represents 32-bit integers, of which a float holds only 24 bits, as two 16-bit halves that the builder recombines.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'

/** Integers that may be large: their lower 16 bits, and the upper 16 bits with the sign. */
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

/** A value of GLSL; an integer known to be small is a single float. */
export type GlslValue = Expression | Halves | Columns

/** Returns one half of a value; `undefined` for the upper half of a float. */
export function halfOf(given: Expression | Halves, isHigh: boolean): Expression | undefined {
  if (given instanceof Halves) return isHigh ? given.high : given.low
  return isHigh ? undefined : given
}

/** Converts a constant int or uint. */
export function halvesOf(glsl: Builder, value: number): Expression | Halves {
  if (Math.abs(value) <= 2 ** 24) return glsl.val!(value)
  const bits = Math.trunc(value) | 0
  return new Halves(glsl.val!(bits & 0xffff), glsl.val!(bits >> 16))
}

/** Recombines the halves by bitwise operations, which are unsupported in GLSL 1.00, whose integers may have fewer bits. */
export const wholeOf = (glsl: Builder, low: Expression, high: Expression): Expression =>
  glsl.bitOr!(glsl.shiftLeft!(glsl.int!(high), glsl.int!(glsl.val!(16))), glsl.int!(low))
