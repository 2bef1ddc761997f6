// Checks of what a caller hands in beside the callback.
import { isClass, isExpression } from '../errors/describe.js'
import { WarpError, describe } from '../errors/errors.js'

/** An object of options, or nothing; `known` names what it may hold. */
export function checkOptions(method: string, options: unknown, known: readonly string[]) {
  if (options === undefined) return
  if (typeof options !== 'object' || options === null || Array.isArray(options))
    throw new WarpError(`${method}: the options must be an object, but are ${describe(options)}.`)
  for (const key in options)
    if (Object.hasOwn(options, key) && !known.includes(key))
      throw new WarpError(
        `${method}: there is no option "${key}"; there ${known.length > 1 ? 'are' : 'is'} ${known.join(', ')}.`,
      )
}

export function checkCallback(method: string, callback: unknown) {
  if (isCallable(callback)) return
  const advice =
    typeof callback === 'string' && callback.includes('{')
      ? '; glslOffset(text) of warpjet/glsl makes a function of one in GLSL'
      : ''
  throw new WarpError(
    `${method}: a function was expected, but ${describe(callback)} came${advice}.`,
  )
}

/** A function, and neither a class nor a component, which may be called too. */
export const isCallable = (value: unknown): value is (...inputs: never[]) => unknown =>
  typeof value === 'function' && !isClass(value) && !isExpression(value)

/** What an object itself holds under a name: `constructor` and `toString` every object has, from `Object`. */
export const own = (object: object, name: string): unknown =>
  Object.hasOwn(object, name) ? Reflect.get(object, name) : undefined

/** An array, typed or not; what is in it is not looked at. */
export const isList = (value: unknown): value is ArrayLike<number> =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value)
