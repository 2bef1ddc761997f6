// Represents 32-bit integers, of which a float holds only 24 bits, as two 16-bit halves that the builder recombines.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'

/** An integer or a vector of integers that may be large: the lower 16 bits, and the upper 16 bits with the sign. */
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

/** A value of GLSL source; an integer that is known to be small is a float. */
export type GlslValue = Expression | Halves | Columns

/** Returns one half of a value. A float has only a lower half, itself: its upper half is `undefined`. */
export function halfOf(value: Expression | Halves, isHigh: boolean): Expression | undefined {
  if (value instanceof Halves) return isHigh ? value.high : value.low
  return isHigh ? undefined : value
}

/** Converts a constant int or uint: to a float if it is small enough, otherwise to halves. */
export function halvesOf(glsl: Builder, value: number): Expression | Halves {
  if (Math.abs(value) <= 2 ** 24) return glsl.val!(value)
  const bits = Math.trunc(value) | 0
  return new Halves(glsl.val!(bits & 0xffff), glsl.val!(bits >> 16))
}

/** Recombines the halves by bitwise operations, which are unsupported in GLSL 1.00, whose integers may have fewer bits. */
export const recombine = (glsl: Builder, low: Expression, high: Expression): Expression =>
  glsl.bitOr!(glsl.shiftLeft!(glsl.int!(high), glsl.int!(glsl.val!(16))), glsl.int!(low))
