// The buffers of the mesh that compute passes measure. Only `needs`, `pieces`, `warped`, `sums` and `state` change.
import { arrayNames } from '../../core/inputs/vertices.js'
import type { DetailParts } from '../detailed-mesh.js'
import { blockSize, stateNames } from './common-wgsl.js'
import type { Passes } from './passes.js'
import { usage, type GpuBuffer, type GpuDevice } from './webgpu.js'

export type BaseBuffers = Readonly<
  Record<
    'samples' | 'warped' | 'topology' | 'base' | 'needs' | 'pieces' | 'sums' | 'state',
    GpuBuffer
  >
>

/** Returns `undefined` if a buffer would be too large. */
export function makeBaseBuffers(
  device: GpuDevice,
  { inputs, pieceCounts, layout }: Passes,
  parts: DetailParts,
): BaseBuffers | undefined {
  const { triangles, sides, topology, pieces, samples, attribute } = parts
  const count = samples.positions.length / 3
  const items = sides + triangles
  const arrays = {
    samples: concatenate(inputs.map(({ input }) => samples[arrayNames[input]]!)),
    topology,
    base: concatenate(layout.attributes.map(({ size }, i) => attribute(i - 1, size))),
    pieces: pieces.map((each) => pieceCounts.indexOf(each)),
  }
  const bytes = {
    ...(Object.fromEntries(
      Object.entries(arrays).map(([name, { byteLength }]) => [name, byteLength]),
    ) as Record<keyof typeof arrays, number>),
    warped: 16 * count,
    needs: 4 * pieces.length,
    sums: 8 * (items + Math.ceil(items / blockSize)),
    state: 4 * (stateNames.length + 3 * triangles),
  }
  const { maxStorageBufferBindingSize, maxBufferSize } = device.limits
  if (Math.max(...Object.values(bytes)) > Math.min(maxStorageBufferBindingSize, maxBufferSize))
    return undefined
  const buffers = Object.fromEntries(
    Object.entries(bytes).map(([name, size]) => [
      name,
      device.createBuffer({
        label: `warpjet detail: ${name}`,
        size,
        usage: usage.storage | usage.copyTo | usage.copyFrom,
      }),
    ]),
  ) as unknown as BaseBuffers
  for (const [name, array] of Object.entries(arrays))
    device.queue.writeBuffer(buffers[name as keyof typeof arrays], 0, array)
  return buffers
}

function concatenate(arrays: readonly ArrayLike<number>[]): Float32Array<ArrayBuffer> {
  const all = new Float32Array(arrays.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const array of arrays) {
    all.set(array, at)
    at += array.length
  }
  return all
}
