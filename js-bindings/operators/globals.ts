// Guesses which names in a function are globals if its script cannot be read.
import { p5Prototype } from './values.js'

const builtInNames = new Set(
  'undefined NaN Infinity globalThis Math Number Array Object String Boolean JSON Map Set WeakMap Date RegExp Symbol BigInt Promise Reflect Proxy Error TypeError RangeError Float32Array Float64Array Int32Array Uint32Array Uint8Array console window self document performance parseInt parseFloat isNaN isFinite'.split(
    ' ',
  ),
)

/** Returns whether a translated function can read a name. `let` at the top of a script makes a global that is no property of `globalThis`. */
export const globalExists = (name: string): boolean =>
  name in globalThis || (isName(name) && typeofGlobal(name) !== 'undefined')

/** References include `this` and `#private`, which are not variables. */
const isName = (name: string) => !/^(this|super|arguments|new\.target|#.*)$/.test(name)

export const typeofGlobal = (name: string): string => typeof valueOfGlobal(name)

/** Returns `undefined` if the name does not exist, or if the page forbids `new Function`. */
export function valueOfGlobal(name: string): unknown {
  try {
    return new Function(`return ${name}`)() as unknown
  } catch {
    return Reflect.get(globalThis, name) as unknown
  }
}

/** Returns whether a global belongs to the page or to p5 rather than to the sketch. */
function isOfHost(name: string): boolean {
  const property = Object.getOwnPropertyDescriptor(globalThis, name)
  return name in p5Prototype() || !!property?.get || (name in globalThis && !property)
}

/**
 * Returns whether a name that the function does not bind is certainly a global. `height` and `key` may be parameters of the
 * enclosing function, whose values would be lost; `sin`, `PI` and `mouseX` hardly ever are.
 */
export function isSurelyGlobal(name: string, isCalled: boolean): boolean {
  if (builtInNames.has(name)) return true
  if (!globalExists(name)) return false
  if (!isOfHost(name)) return true
  if (isCalled) return typeofGlobal(name) === 'function'
  return name in p5Prototype() && /^[A-Z][A-Z0-9_]+$|[a-z][A-Z]/.test(name)
}
