// Tests of values that decide how a value is treated.
import { isClass, isExpression } from '../errors/describe.js'

/** A function, and neither a class nor a component, which may be called too. */
export const isCallable = (value: unknown): value is (...inputs: never[]) => unknown =>
  typeof value === 'function' && !isClass(value) && !isExpression(value)

/** An array, typed or not; what is in it is not looked at. */
export const isList = (value: unknown): value is ArrayLike<number> =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value)

/** A number that stays finite as a float32. */
export const isFiniteFloat = (value: unknown): value is number =>
  typeof value === 'number' && Number.isFinite(Math.fround(value))

/** Reads an object's own property: every object inherits `constructor` and `toString`. */
export const own = (object: object, name: string): unknown =>
  Object.hasOwn(object, name) ? Reflect.get(object, name) : undefined
