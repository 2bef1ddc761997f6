/** The compiler to text, for modules that need no evaluation. A script beside the page's main one uses the compiler of that. */
export { compile } from './compile.js'
export { compileWarp } from './compile-warp-text.js'
