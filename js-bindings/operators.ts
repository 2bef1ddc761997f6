/**
 * 'warpjet/operators': offset functions with `+ - * /`, `if` and `?:`. Once it is imported, or loaded as the script
 * warpjet.operators.min.js, `createWarp`, `compileWarp`, `warp` for three.js and all others that take functions of a vertex
 * translate these operators.
 */
import { operatorsKey } from './errors/operators.js'
import { operators } from './operators/read.js'

export { operators } from './operators/read.js'
export type { Scope } from './operators/read.js'
export { withOperators } from './operators/runtime.js'
export type { Operators } from './operators/runtime.js'

Object.defineProperty(globalThis, operatorsKey, {
  value: operators,
  configurable: true,
})
