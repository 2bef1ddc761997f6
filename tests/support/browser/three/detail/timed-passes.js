// Measures compute passes by timestamps of the GPU.

const maxDispatches = 16

/**
 * Measures the compute passes of encoders with this label. Returns a function that reads the milliseconds of the last encoder: the total
 * of its dispatches, or the time of each if `isSplit()`. Returns `undefined` if the device has no timestamps.
 */
export function timePasses(device, label, isSplit) {
  if (!device.features.has('timestamp-query')) return undefined
  const count = 2 * maxDispatches
  const times = device.createQuerySet({ type: 'timestamp', count })
  const [resolved, copy] = [
    GPUBufferUsage.QUERY_RESOLVE | GPUBufferUsage.COPY_SRC,
    GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST,
  ].map((usage) => device.createBuffer({ size: 8 * count, usage }))
  let written = 0
  let isMapped = false
  const { createCommandEncoder } = device
  device.createCommandEncoder = (settings) => {
    const encoder = createCommandEncoder.call(device, settings)
    if (settings?.label !== label || isMapped) return encoder
    const { beginComputePass, finish } = encoder
    written = 0
    const begin = () => {
      const first = 2 * written++
      const timestampWrites = {
        querySet: times,
        beginningOfPassWriteIndex: first,
        endOfPassWriteIndex: first + 1,
      }
      return beginComputePass.call(encoder, { label, timestampWrites })
    }
    encoder.beginComputePass = () => (isSplit() ? splitEach(begin) : begin())
    encoder.finish = () => {
      encoder.resolveQuerySet(times, 0, 2 * written, resolved, 0)
      encoder.copyBufferToBuffer(resolved, 0, copy, 0, 16 * written)
      return finish.call(encoder)
    }
    return encoder
  }
  return async () => {
    isMapped = true
    await copy.mapAsync(GPUMapMode.READ)
    const at = [...new BigUint64Array(copy.getMappedRange())].map(Number)
    copy.unmap()
    isMapped = false
    return Array.from({ length: written }, (_, i) => (at[2 * i + 1] - at[2 * i]) / 1e6)
  }
}

/** Gives each dispatch a pass of its own. */
function splitEach(begin) {
  let pipeline, bindings
  return {
    setPipeline: (given) => void (pipeline = given),
    setBindGroup: (_, given) => void (bindings = given),
    dispatchWorkgroups(groups) {
      const pass = begin()
      pass.setPipeline(pipeline)
      pass.setBindGroup(0, bindings)
      pass.dispatchWorkgroups(groups)
      pass.end()
    },
    end() {},
  }
}
