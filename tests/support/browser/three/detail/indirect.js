// Reads buffers that compute passes write.

/** Reads `count` numbers of an attribute from the GPU; all of them by default. */
export async function readBuffer({ backend }, attribute, Numbers, count) {
  const { buffer } = backend.get(attribute)
  const size = count === undefined ? buffer.size : 4 * count
  const copy = backend.device.createBuffer({
    size,
    usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST,
  })
  const encoder = backend.device.createCommandEncoder()
  encoder.copyBufferToBuffer(buffer, 0, copy, 0, size)
  backend.device.queue.submit([encoder.finish()])
  await copy.mapAsync(GPUMapMode.READ)
  const numbers = new Numbers(copy.getMappedRange().slice())
  copy.destroy()
  return numbers
}

/** Reads the drawn indices, and the values of an attribute. Returns { indices, numbers }. */
export async function readDrawn(renderer, { indirect, index, attributes }, name = 'position') {
  const [count] = await readBuffer(renderer, indirect, Uint32Array)
  const indices = await readBuffer(renderer, index, Uint32Array, count)
  const { data, offset, itemSize } = attributes[name]
  const all = await readBuffer(renderer, data, Float32Array)
  const vertices = indices.reduce((a, b) => Math.max(a, b), 0) + 1
  const numbers = new Float32Array(itemSize * vertices)
  for (let i = 0; i < vertices; i++)
    numbers.set(
      all.subarray(data.stride * i + offset, data.stride * i + offset + itemSize),
      itemSize * i,
    )
  return { indices, numbers }
}
