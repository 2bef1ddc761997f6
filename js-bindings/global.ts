/** The members of the global `warpjet` of a page. Further scripts, such as that of deformers, add their own. */
export { compile, gen } from './compile/compile.js'
export { compileWarp } from './compile/compile-warp.js'
export { WarpError } from './errors/errors.js'
export { version } from './generated/version.js'
