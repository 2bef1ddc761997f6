// Judges which names in a function are globals if its script cannot be seen.
import { p5Prototype } from './values.js'

const isUsual = new Set(
  'undefined NaN Infinity globalThis Math Number Array Object String Boolean JSON Map Set WeakMap Date RegExp Symbol BigInt Promise Reflect Proxy Error TypeError RangeError Float32Array Float64Array Int32Array Uint32Array Uint8Array console window self document performance parseInt parseFloat isNaN isFinite'.split(
    ' ',
  ),
)

/** Returns whether a translated function can read a name. `let` at the top of a script is global, but no property of `globalThis`. */
export const isThere = (name: string): boolean =>
  name in globalThis || (isName(name) && typeofGlobal(name) !== 'undefined')

/** References include `this` and `#private`, which are no variables. */
const isName = (name: string) => !/^(this|super|arguments|new\.target|#.*)$/.test(name)

export const typeofGlobal = (name: string): string => typeof valueOfGlobal(name)

/** Nothing if there is no such name, or if the page forbids to ask. */
export function valueOfGlobal(name: string): unknown {
  try {
    return new Function(`return ${name}`)() as unknown
  } catch {
    return Reflect.get(globalThis, name) as unknown
  }
}

/** Returns whether a global belongs to the page or to p5, and is no variable of the sketch. */
function isOfHost(name: string): boolean {
  const property = Object.getOwnPropertyDescriptor(globalThis, name)
  return name in p5Prototype() || !!property?.get || (name in globalThis && !property)
}

/**
 * Returns true if a name that the function does not bind is surely a global. `height` and `key` may as well be a parameter of the
 * function around it, which then would be lost; `sin`, `PI` and `mouseX` are hardly ever one.
 */
export function isSurelyGlobal(name: string, isCalled: boolean): boolean {
  if (isUsual.has(name)) return true
  if (!isThere(name)) return false
  if (!isOfHost(name)) return true
  if (isCalled) return typeofGlobal(name) === 'function'
  return name in p5Prototype() && /^[A-Z][A-Z0-9_]+$|[a-z][A-Z]/.test(name)
}
