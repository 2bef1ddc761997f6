/** Views of arrays in wasm memory. They are kept, since a view is an object. */
export class Views {
  private readonly views: Float32Array[] = []

  /**
   * Returns the view of index `i`: the previous one if it shows the same part, as it mostly does. A view becomes empty if the memory grows.
   */
  get(i: number, floats: Float32Array, start: number, count: number): Float32Array {
    const last = this.views[i]
    if (last?.length === count && last.byteOffset === 4 * start) return last
    return (this.views[i] = floats.subarray(start, start + count))
  }
}
