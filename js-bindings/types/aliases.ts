// Other names of operations; js-bindings/expression/aliases.ts has them and says where they come from.
import type { sameAs } from '../expression/aliases.js'
import type { Scalar } from './expressions.js'

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
}

export interface MadeVectorMethods {
  /** The square of the length. */
  magSq(): Scalar
  /** The square of the length. */
  lengthSq(): Scalar
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
}
