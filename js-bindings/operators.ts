/**
 * 'warpjet/operators': offset functions with `+ - * /`, `if` and `?:`. Imported, or as the script warpjet.operators.min.js, it
 * also makes p5's `createWarp` read functions so.
 */
import { operators } from './operators/read.js'

export { operators } from './operators/read.js'
export type { Scope } from './operators/read.js'
export { withOperators } from './operators/runtime.js'
export type { Operators } from './operators/runtime.js'

Object.defineProperty(globalThis, Symbol.for('warpjet.operators'), {
  value: operators,
  configurable: true,
})
