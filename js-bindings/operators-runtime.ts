// 'warpjet/operators/runtime': what translated modules import.
export { operators, withOperators } from './operators/runtime.js'
