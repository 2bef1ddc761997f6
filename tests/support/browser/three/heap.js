/**
 * The bytes of JavaScript's heap in use when all that can go is gone; the browser runs with --expose-gc. What a weak
 * reference was asked for lives until the turn ends, and what hangs on it goes with the next collection.
 */
export async function settledHeap() {
  for (let turn = 0; turn < 4; turn++) {
    await new Promise((resolve) => setTimeout(resolve, 20))
    globalThis.gc?.()
  }
  return performance.memory?.usedJSHeapSize
}
