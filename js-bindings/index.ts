// 'warpjet': compiles offset functions, and any other functions, into shader text and for the CPU.
export { compile, gen } from './compile/compile.js'
export type { CompiledExpressions, GenSettings } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp.js'
export type { CompiledWarp } from './compile/compile-warp.js'
export type { Compiled, CompileOptions, Declared, Stats } from './module/result.js'
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
export { targets, type Target } from './module/kept-module.js'
export type { TypeName } from './expression/shapes.js'
export type { Numbers } from './cpu/double.js'
export { WarpError } from './checks/errors.js'
export { version } from './generated/version.js'
export type { InputName } from './inputs/inputs.js'
export type * from './types/noise.js'
export type * from './types/types.js'
export type { Box, Uniforms, Vertices } from './inputs/vertices.js'
export type {
  InputNames,
  OutputNames,
  TextOptions,
  WarpOptions,
  WarpText,
} from './compile/warp-text.js'
