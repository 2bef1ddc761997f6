// The buffers that compute passes write and an indirect call draws: the divided mesh.
import type { DetailedMesh } from '../detailed-mesh.js'
import { usage, type GpuBuffer, type GpuDevice, type GpuEncoder } from './webgpu.js'

export interface Room {
  readonly vertices: number
  readonly triangles: number
}

/** Room for twice as much as a mesh has now, so that it grows rarely. */
const spare = 2

export class DividedBuffers {
  room: Room = { vertices: 0, triangles: 0 }
  /** The numbers of all attributes of a vertex, then those of the next one. */
  vertices!: GpuBuffer
  indices!: GpuBuffer
  /** The five numbers of `drawIndexedIndirect`. */
  readonly drawn: GpuBuffer
  private readonly stride: number

  private constructor(
    private readonly device: GpuDevice,
    /** The numbers per vertex of each attribute; the first one is positions. */
    private readonly sizes: readonly number[],
  ) {
    this.stride = sizes.reduce((sum, size) => sum + size, 0)
    this.drawn = this.make('draw call', 20, usage.indirect)
  }

  /** Copies a mesh that the CPU has divided; `undefined` if it is too large. */
  static copyOf(device: GpuDevice, mesh: DetailedMesh, sizes: readonly number[]) {
    const buffers = new DividedBuffers(device, sizes)
    const indices = mesh.indices()
    const vertices = mesh.values(-1).length / 3
    if (!buffers.grow({ vertices, triangles: indices.length / 3 })) {
      buffers.drawn.destroy()
      return undefined
    }
    device.queue.writeBuffer(buffers.indices, 0, indices)
    device.queue.writeBuffer(buffers.vertices, 0, buffers.interleave(mesh, vertices))
    device.queue.writeBuffer(buffers.drawn, 0, new Uint32Array([indices.length, 1, 0, 0, 0]))
    return buffers
  }

  /** Makes room for more. With an encoder, the present mesh is copied. Returns `false` if a buffer would be too large. */
  grow({ vertices, triangles }: Room, encoder?: GpuEncoder): boolean {
    const { maxStorageBufferBindingSize, maxBufferSize } = this.device.limits
    const room = {
      vertices: Math.max(spare * vertices, this.room.vertices),
      triangles: Math.max(spare * triangles, this.room.triangles),
    }
    const bytes = [4 * this.stride * room.vertices, 12 * room.triangles] as const
    if (Math.max(...bytes) > Math.min(maxStorageBufferBindingSize, maxBufferSize)) return false
    const before = [this.vertices, this.indices]
    this.vertices = this.make('vertices', bytes[0], usage.vertex)
    this.indices = this.make('indices', bytes[1], usage.index)
    const after = [this.vertices, this.indices]
    if (encoder)
      before.forEach((from, i) => encoder.copyBufferToBuffer(from, 0, after[i]!, 0, from.size))
    this.room = room
    return true
  }

  destroy() {
    for (const buffer of [this.vertices, this.indices, this.drawn]) buffer.destroy()
  }

  private make(name: string, size: number, flag: number) {
    const flags = usage.storage | usage.copyTo | usage.copyFrom | flag
    return this.device.createBuffer({ label: `warpjet detail: ${name}`, size, usage: flags })
  }

  private interleave(mesh: DetailedMesh, vertices: number) {
    const array = new Float32Array(this.stride * vertices)
    let offset = 0
    this.sizes.forEach((size, attribute) => {
      const values = mesh.values(attribute - 1)
      for (let i = 0, at = offset; i < values.length; i += size, at += this.stride)
        for (let k = 0; k < size; k++) array[at + k] = values[i + k]!
      offset += size
    })
    return array
  }
}
