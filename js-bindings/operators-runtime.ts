// 'warpjet/operators/runtime': imported by translated modules.
export { operators, withOperators } from './operators/runtime.js'
