/** The compiler to shader code, for modules that need no evaluation. A page's other scripts use the compiler of its main script. */
export { compile } from './compile.js'
export { compileWarp } from './compile-warp-text.js'
