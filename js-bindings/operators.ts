/**
 * 'warpjet/operators': offset functions with `+ - * /`, `if` and `?:`. Imported, or as the script warpjet.operators.min.js, it
 * also makes `createWarp`, `compileWarp`, `warp` of three.js and all else that takes functions of a vertex read them so.
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
