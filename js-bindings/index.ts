// 'warpjet': compiles offset functions, and any other functions, into shader text.
export { compile, compileWarp, gen } from './compile.js'
export type {
  Compiled,
  CompiledExpressions,
  CompiledWarp,
  CompileOptions,
  GenSettings,
  InputName,
  Stats,
  WarpOptions,
} from './compile.js'
export { targets, type Target } from './compilation.js'
export type { Numbers } from './evaluate.js'
export { memoryInUse } from './core.js'
export { WarpError } from './errors.js'
export { version } from './generated/version.js'
export type * from './types.js'
