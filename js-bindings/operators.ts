/**
 * 'warpjet/operators': offset functions with `+ - * /`, `if` and `?:`. Once it is imported, or loaded as the script
 * warpjet.operators.min.js, these operators are translated in all offset functions, whether they are passed to `createWarp`, `compileWarp`,
 * `warp` for three.js or others.
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
