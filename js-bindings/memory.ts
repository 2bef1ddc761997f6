// For tests and benchmarks only, not in the package: functions that return the number of bytes that each wasm module has allocated, which is
// always the same while no call runs; and the wasm module that divides meshes.
export { memoryInUse } from './wasm/core.js'
export { evaluationMemoryInUse } from './wasm/evaluation.js'
export { glslMemoryInUse } from './wasm/glsl.js'
export { detailMemoryInUse, details } from './wasm/detail.js'
export { meshMemoryInUse } from './wasm/mesh.js'
