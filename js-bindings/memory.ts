// For tests alone, and not in the package: how many bytes each wasm holds. Between two calls it is always the same.
export { memoryInUse } from './core.js'
export { evaluationMemoryInUse } from './evaluation.js'
export { meshMemoryInUse } from './mesh/module.js'
