/** What the global `warpjet` of a page holds; the script of deformers adds its own. */
export { compile, gen } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp.js'
export { WarpError } from './errors/errors.js'
export { version } from './generated/version.js'
