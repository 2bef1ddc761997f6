// Type guards for values that users pass.
import { isClass, isExpression } from '../errors/describe.js'

/** Tests for a function that is neither a class nor an expression, since an expression such as the component `v.x` can be called too. */
export const isCallable = (value: unknown): value is (...inputs: never[]) => unknown =>
  typeof value === 'function' && !isClass(value) && !isExpression(value)

/** Tests for an array, typed or not, whatever its elements are. */
export const isList = (value: unknown): value is ArrayLike<number> =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value)

/** Tests for a number that is finite as a float32. */
export const isFiniteFloat = (value: unknown): value is number =>
  typeof value === 'number' && Number.isFinite(Math.fround(value))

/** Returns the value of an object's own property; `undefined` for inherited ones, such as `constructor` and `toString`. */
export const ownProperty = (object: object, name: string): unknown =>
  Object.hasOwn(object, name) ? Reflect.get(object, name) : undefined
