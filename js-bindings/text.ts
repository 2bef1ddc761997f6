// 'warpjet/text': all of 'warpjet' but what runs warps on the CPU, at half its size.
export { compile, gen } from './compile/compile.js'
export type { CompiledExpressions, GenSettings } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp-text.js'
export type { Compiled, CompileOptions, Declared, Stats } from './module/result.js'
export { targets, type Target } from './module/kept-module.js'
export type { Numbers } from './cpu/double.js'
export { WarpError } from './checks/errors.js'
export { version } from './generated/version.js'
export type { InputName } from './inputs/inputs.js'
export type * from './types/noise.js'
export type * from './types/types.js'
export type { TypeName } from './expression/shapes.js'
export type {
  InputNames,
  OutputNames,
  TextOptions,
  WarpOptions,
  WarpText,
} from './compile/warp-text.js'
