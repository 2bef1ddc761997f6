// The façade for adapters of hosts, which import nothing else from core, compile and cpu.
export { HostWarp } from './host-warp.js'
export type { Host } from './host.js'
export type { FrameConstants } from './frame.js'
export { type HostText, otherName } from './warp-text.js'
export type { HostOptions } from './offset-warp.js'
export type { Expression } from '../core/expression/expression.js'
export type { HostUniform } from './host-uniforms.js'
export {
  type ImageSampling,
  type Wrap,
  samplingNumbers,
  samplingUniforms,
} from './image-sampling.js'
export { type NormalStage, type NormalsOption, normalsKinds } from './normals-option.js'
export type { Result } from './recorded-warp.js'
export { restoreLength, shaderNames, withLength } from './shader-names.js'
export { arraysOf, attributeNumbers, geometryAttributes } from '../core/inputs/geometry.js'
export {
  type VariationInput,
  drawInputs,
  variationAttribute,
  variationNames,
} from '../core/inputs/inputs.js'
export { componentsOf, imageFor, scalarOrArray } from '../core/inputs/uniform-values.js'
export { type Vertices, arrayNames } from '../core/inputs/vertices.js'
export type { Target } from '../core/module/serialized-module.js'
export { lazily } from '../core/module/lazily.js'
export type { Declared } from '../core/module/result.js'
export type { Vec3 } from '../core/types/expressions.js'
export type {
  OffsetFunction,
  UniformExpressions,
  UniformOptions,
  UniformOverrides,
  UniformValues,
  WarpInputs,
} from '../core/types/types.js'
/** Starts the compiler, as the first warp does. */
export { getCore as startCompiler } from '../wasm/core.js'
