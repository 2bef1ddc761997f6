/** `compile` and `compileWarp` for the script of shader text, which stands beside the one that holds the compiler. */
const { warpjet } = globalThis as unknown as {
  warpjet: Pick<typeof import('../compile/compile.js'), 'compile'> &
    Pick<typeof import('../compile/compile-warp.js'), 'compileWarp'>
}

export const { compile, compileWarp } = warpjet
