/** Exports the compiler of the page's main script, for warpjet.glsl.min.js. */
const { warpjet } = globalThis as unknown as { warpjet: typeof import('./text-compiler.js') }

export const { compile, compileWarp } = warpjet
