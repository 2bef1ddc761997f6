// 'warpjet': compiles offset functions, and any other functions, to shader code and for the CPU.
export { compile, gen } from './compile/compile.js'
export type { CompiledExpressions, GenSettings } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp.js'
export type { CompiledWarp } from './compile/compile-warp.js'
export type { Compiled, CompileOptions, Declared, Stats } from './core/module/result.js'
export type {
  Bounds,
  CpuWarp,
  EvaluateOptions,
  EvaluationOptions,
  Foldover,
  InverseOptions,
  PointInputs,
  WarpInverse,
  WarpedPoint,
} from './cpu/cpu-warp.js'
export type { WarpedVertices } from './cpu/results.js'
export { targets, type Target } from './core/module/serialized-module.js'
export type { TypeName } from './core/expression/shapes.js'
export type { Numbers } from './cpu/double.js'
export { WarpError } from './errors/errors.js'
export { version } from './generated/version.js'
export type { InputName } from './core/inputs/inputs.js'
export type * from './core/types/noise.js'
export type * from './core/types/types.js'
export type { Box, Uniforms, Vertices } from './core/inputs/vertices.js'
export type { InputNames, OutputNames, TextOptions, WarpOptions } from './compile/warp-options.js'
export type { NormalStage, NormalsOption } from './compile/normals-option.js'
export type { WarpText } from './compile/warp-text.js'
