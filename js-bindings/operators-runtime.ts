// 'warpjet/operators/runtime': what translated modules import.
export { withOperators } from './operators/runtime.js'
