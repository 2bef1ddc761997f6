/** Records the peaks of the page's JavaScript heap and of WebAssembly memory, in bytes, at the moments `record` is called. */

/** The memories exported by a WebAssembly module of this page. Import this file before any such module. */
const memories = new Set()

const { Instance } = WebAssembly
WebAssembly.Instance = class extends Instance {
  constructor(...args) {
    super(...args)
    for (const value of Object.values(this.exports))
      if (value instanceof WebAssembly.Memory) memories.add(value)
  }
}

/** @returns { record, peaks }; `peaks()` returns { heap, wasm }, where `heap` is NaN in browsers that do not report it */
export function watchMemory() {
  let heap = 0
  let wasm = 0
  const record = () => {
    heap = Math.max(heap, performance.memory?.usedJSHeapSize ?? NaN)
    wasm = Math.max(
      wasm,
      [...memories].reduce((sum, { buffer }) => sum + buffer.byteLength, 0),
    )
  }
  record()
  return { record, peaks: () => (record(), { heap, wasm }) }
}
