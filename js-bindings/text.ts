// 'warpjet/text': all of 'warpjet' but what runs warps on the CPU, at half its size.
export { compile, gen } from './compile/compile.js'
export type { CompiledExpressions, GenSettings } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp-text.js'
export type { Compiled, CompileOptions, Declared, Stats } from './core/module/result.js'
export { targets, type Target } from './core/module/kept-module.js'
export type { Numbers } from './cpu/double.js'
export { WarpError } from './errors/errors.js'
export { version } from './generated/version.js'
export type { InputName } from './core/inputs/inputs.js'
export type * from './core/types/noise.js'
export type * from './core/types/types.js'
export type { TypeName } from './core/expression/shapes.js'
export type {
  InputNames,
  OutputNames,
  TextOptions,
  WarpOptions,
  WarpText,
} from './compile/warp-text.js'
