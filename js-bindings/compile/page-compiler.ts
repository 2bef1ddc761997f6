/** The compiler of the page's main script, for the script of shader text beside it. */
const { warpjet } = globalThis as unknown as { warpjet: typeof import('./text-compiler.js') }

export const { compile, compileWarp } = warpjet
