// The tessellations of triangles for compute passes, table once per page while it is idle.
import { details } from '../../wasm/detail.js'

let table: Promise<Uint32Array<ArrayBuffer>> | undefined

/** Returns the words of src/detail/tessellation_table.hpp: about 1.9 MB, which take a second or more in total. */
export const tessellationTable = (): Promise<Uint32Array<ArrayBuffer>> =>
  (table ??= makeTable().catch((error) => {
    table = undefined
    throw error
  }))

/** The time for which the page is blocked at once, in milliseconds. A single tessellation can take longer. */
const sliceLength = 4

async function makeTable() {
  const bound = details.get()
  const builder = new bound.TessellationTable()
  try {
    for (let isDone = false; !isDone;) {
      await waitUntilIdle()
      if (bound.isBroken) throw new Error('the wasm module failed')
      const end = performance.now() + sliceLength
      while (!isDone && performance.now() < end) isDone = !builder.makeNext()
    }
    return builder.words().slice()
  } finally {
    if (!bound.isBroken) builder.delete()
  }
}

/** Waits until the page is idle, or 10 ms in Safari, which has no `requestIdleCallback`. */
const waitUntilIdle = () =>
  new Promise<unknown>((resolve) =>
    'requestIdleCallback' in globalThis
      ? requestIdleCallback(resolve, { timeout: 50 })
      : setTimeout(resolve, 10),
  )
