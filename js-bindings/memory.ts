// For tests and benchmarks only, not in the package: the number of bytes that each wasm module holds, which is the same between any two
// calls, and the module that divides meshes.
export { memoryInUse } from './wasm/core.js'
export { evaluationMemoryInUse } from './wasm/evaluation.js'
export { glslMemoryInUse } from './wasm/glsl.js'
export { detailMemoryInUse, details } from './wasm/detail.js'
export { meshMemoryInUse } from './wasm/mesh.js'
