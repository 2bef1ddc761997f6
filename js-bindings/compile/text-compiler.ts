/** The compiler to shader code, for modules that need no evaluation. Further scripts of a page use that of its main script. */
export { compile } from './compile.js'
export { compileWarp } from './compile-warp-text.js'
