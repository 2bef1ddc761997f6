// C's mathematics, from JavaScript: musl's would be 20 KB in each wasm.

/**
 * Under the names that Emscripten's -sJS_MATH gives them: the core folds constants by them, the evaluation computes ranges and
 * what its own four lanes leave aside.
 */
export function mathematics() {
  const names = Object.getOwnPropertyNames(Math) as Exclude<keyof Math, symbol>[]
  return {
    ...Object.fromEntries(names.map((name) => [`JS_${name}`, Math[name]])),
    // C rounds halves away from zero.
    JS_round: (x: number) => (x >= 0 ? Math.floor(x + 0.5) : Math.ceil(x - 0.5)),
  }
}
