// For tests only, not in the package: the number of bytes that each wasm module holds, which is the same between any two calls.
export { memoryInUse } from './wasm/core.js'
export { evaluationMemoryInUse } from './wasm/evaluation.js'
export { glslMemoryInUse } from './wasm/glsl.js'
export { detailMemoryInUse } from './wasm/detail.js'
export { meshMemoryInUse } from './wasm/mesh.js'
