// The types of aliases, which js-bindings/core/expression/aliases.ts defines.
import type { aliases } from '../expression/aliases.js'
import type { Operand, Scalar, Vec2, Vector } from './expressions.js'

type Names = typeof aliases

/** The aliases of the given methods. */
export type AliasesOf<Methods> = {
  [
    Alias in keyof Names as Names[Alias] extends keyof Methods ? Alias : never
  ]: Methods[Names[Alias] & keyof Methods]
}

/** Composed methods of numbers and vectors, by component. */
export interface MadeMethods<Self> {
  /** 1 - x */
  oneMinus(): Self
  /** x, limited to the range from 0 to 1. */
  saturate(): Self
  /** 1 / x */
  reciprocal(): Self
  /** x * x */
  pow2(): Self
  /** x * x * x */
  pow3(): Self
  /** The same expression, since expressions never change. */
  copy(): Self
  /** The remainder of a division, x - divisor * trunc(x / divisor), with the sign of x, like JavaScript's `%`. */
  rem(divisor: Self | Operand): Self
}

/** Composed methods of vectors. */
export interface MadeVectorMethods<Self> {
  /** The square of the length. */
  magSq(): Scalar
  /** The square of the length. */
  lengthSq(): Scalar
  /** The remainder of a division, x - divisor * trunc(x / divisor), with the sign of x, like JavaScript's `%`. */
  rem(divisor: Self | Operand): Self
  /** The remainder of the division of each component by its own divisor. */
  rem(x: Operand, y: Operand, ...zw: Operand[]): Self
  /** The vector, shortened to a maximum length. */
  limit(length: Operand): Self
  /** A vector with the same direction and the given length. */
  setMag(length: Operand): Self
  /** The angle of x and y, from -π to π. */
  heading(): Scalar
  /** The angle from a vec2 or vec3 to another one, from -π to π, with the sign that p5 gives it. */
  angleBetween(v: Self): Scalar
  /** The components. */
  array(): Scalar[]
}

/** Methods of a vec2 only. */
export interface Vec2Methods {
  /** The vector rotated by an angle in radians. */
  rotate(angle: Operand): Vec2
}

/** The composed methods as functions of `glsl`. */
export interface MadeFunctions {
  /** 1 - x */
  oneMinus<Value extends object>(x: Value): Value
  /** x, limited to the range from 0 to 1. */
  saturate<Value extends object>(x: Value): Value
  /** 1 / x */
  reciprocal<Value extends object>(x: Value): Value
  /** x * x */
  pow2<Value extends object>(x: Value): Value
  /** x * x * x */
  pow3<Value extends object>(x: Value): Value
  /** The square of the length of a vector. */
  magSq(v: object): Scalar
  /** The square of the length of a vector. */
  lengthSq(v: object): Scalar
  /** The same expression. */
  copy<Value extends object>(x: Value): Value
  /** The remainder of a division, with the sign of x. */
  rem<Value extends object>(x: Value, ...divisor: (Value | Operand)[]): Value
  /** The vector, shortened to a maximum length. */
  limit<Value extends Vector>(v: Value, length: Operand): Value
  /** A vector with the same direction and the given length. */
  setMag<Value extends Vector>(v: Value, length: Operand): Value
  /** The angle of x and y. */
  heading(v: Vector): Scalar
  /** The angle from one vec2 or vec3 to another. */
  angleBetween<Value extends Vector>(a: Value, b: Value): Scalar
}
