// 'warpjet': compiles offset functions, and any other functions, into shader text and for the CPU.
export { compile, gen } from './compile.js'
export type { CompiledExpressions, GenSettings } from './compile.js'
export { compileWarp } from './compile-warp.js'
export type { CompiledWarp } from './compile-warp.js'
export type { Compiled, CompileOptions, Declared, Stats } from './compiled.js'
export type {
  CpuWarp,
  EvaluationOptions,
  Foldover,
  PointInputs,
  WarpedPoint,
  WarpedVertices,
} from './cpu-warp.js'
export { targets, type Target } from './kept-module.js'
export type { TypeName } from './shapes.js'
export type { Numbers } from './evaluate.js'
export { WarpError } from './errors.js'
export { version } from './generated/version.js'
export type { InputName } from './inputs.js'
export type * from './noise-types.js'
export type * from './types.js'
export type { Box, Uniforms, Vertices } from './vertices.js'
export type { InputNames, OutputNames, TextOptions, WarpOptions, WarpText } from './warp-text.js'
