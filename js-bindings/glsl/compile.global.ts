/** `compile` and `compileWarp` for the script of shader text, which stands beside the one that holds the compiler. */
const { warpjet } = globalThis as unknown as { warpjet: typeof import('../global.js') }

export const { compile, compileWarp } = warpjet
