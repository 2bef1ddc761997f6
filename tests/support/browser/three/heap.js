/**
 * Returns the size of JavaScript's heap in bytes after garbage collection; the browser runs with --expose-gc. Collects several times,
 * since an object read from a weak reference lives until the end of the task, and what it refers to until the next collection.
 */
export async function settledHeap() {
  for (let turn = 0; turn < 4; turn++) {
    await new Promise((resolve) => setTimeout(resolve, 20))
    globalThis.gc?.()
  }
  return performance.memory?.usedJSHeapSize
}
