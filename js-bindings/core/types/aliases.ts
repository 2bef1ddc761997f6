// Other names of operations; js-bindings/core/expression/aliases.ts has them and says where they come from.
import type { sameAs } from '../expression/aliases.js'
import type { Operand, Scalar, Vec2, Vector } from './expressions.js'

type Names = typeof sameAs

/** Of the methods that there are. */
export type AliasesOf<Methods> = {
  [
    Alias in keyof Names as Names[Alias] extends keyof Methods ? Alias : never
  ]: Methods[Names[Alias] & keyof Methods]
}

/** Of numbers and vectors, by component. */
export interface MadeMethods<Self> {
  /** 1 - x */
  oneMinus(): Self
  /** Between 0 and 1. */
  saturate(): Self
  /** 1 / x */
  reciprocal(): Self
  /** x * x */
  pow2(): Self
  /** x * x * x */
  pow3(): Self
  /** The same expression: none ever changes. */
  copy(): Self
  /** The rest of a division, x - divisor * trunc(x / divisor), which has the sign of x as JavaScript's `%`. */
  rem(divisor: Self | Operand): Self
}

export interface MadeVectorMethods<Self> {
  /** The square of the length. */
  magSq(): Scalar
  /** The square of the length. */
  lengthSq(): Scalar
  /** The rest of a division, x - divisor * trunc(x / divisor), which has the sign of x as JavaScript's `%`. */
  rem(divisor: Self | Operand): Self
  /** The rest of a division of each component by a number of its own. */
  rem(x: Operand, y: Operand, ...zw: Operand[]): Self
  /** The same direction, but no longer than that. */
  limit(length: Operand): Self
  /** The same direction with that length. */
  setMag(length: Operand): Self
  /** The angle of x and y, from -π to π. */
  heading(): Scalar
  /** The angle to another vector, from -π to π, as p5 signs it; of a vec2 or vec3. */
  angleBetween(v: Self): Scalar
  /** Its components. */
  array(): Scalar[]
}

/** Of a vec2. */
export interface Vec2Methods {
  /** The vector turned by an angle in radians. */
  rotate(angle: Operand): Vec2
}

/** The same as functions of the builder. */
export interface MadeFunctions {
  /** 1 - x */
  oneMinus<Value extends object>(x: Value): Value
  /** Between 0 and 1. */
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
  /** The rest of a division, which has the sign of x. */
  rem<Value extends object>(x: Value, ...divisor: (Value | Operand)[]): Value
  /** The same direction, but no longer than that. */
  limit<Value extends Vector>(v: Value, length: Operand): Value
  /** The same direction with that length. */
  setMag<Value extends Vector>(v: Value, length: Operand): Value
  /** The angle of x and y. */
  heading(v: Vector): Scalar
  /** The angle from one vec2 or vec3 to another. */
  angleBetween<Value extends Vector>(a: Value, b: Value): Scalar
}
