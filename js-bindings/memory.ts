// For tests alone, and not in the package: how many bytes each wasm holds. Between two calls it is always the same.
export { memoryInUse } from './wasm/core.js'
export { evaluationMemoryInUse } from './wasm/evaluation.js'
export { glslMemoryInUse } from './wasm/glsl.js'
export { meshMemoryInUse } from './wasm/mesh.js'
