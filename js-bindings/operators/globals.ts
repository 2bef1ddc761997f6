// Guesses which names in a function are globals if its script cannot be read.
import { p5Prototype } from './values.js'

const builtInNames = new Set(
  'undefined NaN Infinity globalThis Math Number Array Object String Boolean JSON Map Set WeakMap Date RegExp Symbol BigInt Promise Reflect Proxy Error TypeError RangeError Float32Array Float64Array Int32Array Uint32Array Uint8Array console window self document performance parseInt parseFloat isNaN isFinite'.split(
    ' ',
  ),
)

/** Returns whether a translated function can read a name. `let` at the top of a script makes a global that is no property of `globalThis`. */
export const globalExists = (name: string): boolean =>
  name in globalThis || (isVariableName(name) && typeofGlobal(name) !== 'undefined')

/** Returns whether a name of `References` is a variable's: such names can also be `this` or `#private`. */
const isVariableName = (name: string) => !/^(this|super|arguments|new\.target|#.*)$/.test(name)

export const typeofGlobal = (name: string): string => typeof valueOfGlobal(name)

/** Returns the value of a global; `undefined` if it does not exist, or if it is not in `globalThis` and the page forbids `new Function`. */
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
 * Returns whether a name that the function does not bind is certainly a global. If `height` is a parameter of the enclosing function,
 * treating it as p5's global would read the wrong value. Names such as `sin`, `PI` and `mouseX` are hardly ever parameters.
 */
export function isSurelyGlobal(name: string, isCalled: boolean): boolean {
  if (builtInNames.has(name)) return true
  if (!globalExists(name)) return false
  if (!isOfHost(name)) return true
  if (isCalled) return typeofGlobal(name) === 'function'
  return name in p5Prototype() && /^[A-Z][A-Z0-9_]+$|[a-z][A-Z]/.test(name)
}
