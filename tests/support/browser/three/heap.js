/**
 * Returns the size of JavaScript's heap in bytes after garbage collection; the browser must run with --expose-gc. Collects several times,
 * since an object that was read from a weak reference lives until the end of the task, and the objects to which it refers until the next
 * collection.
 */
export async function measureHeap() {
  for (let turn = 0; turn < 4; turn++) {
    await new Promise((resolve) => setTimeout(resolve, 20))
    globalThis.gc?.()
  }
  return performance.memory?.usedJSHeapSize
}
