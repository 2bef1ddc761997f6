// The buffers of a divided mesh, which compute passes write and an indirect call draws.
import type { DetailedMesh } from '../detailed-mesh.js'
import type { VertexLayout } from './vertex-layout.js'
import { usage, type GpuBuffer, type GpuDevice, type GpuEncoder } from './webgpu.js'

export interface Room {
  readonly vertices: number
  readonly triangles: number
}

/** Buffers have room for twice as much as the mesh needs, so that they grow rarely. */
const growth = 2

export class DividedBuffers {
  room: Room = { vertices: 0, triangles: 0 }
  vertices!: GpuBuffer
  indices!: GpuBuffer
  /** The five numbers of `drawIndexedIndirect`. */
  readonly drawn: GpuBuffer
  /** Buffers that larger ones have replaced. */
  private outgrown: GpuBuffer[] = []

  private constructor(
    private readonly device: GpuDevice,
    readonly layout: VertexLayout,
  ) {
    this.drawn = this.make('draw call', 20, usage.indirect)
  }

  /** Copies a mesh that the CPU has divided; `undefined` if it is too large. */
  static copyOf(device: GpuDevice, mesh: DetailedMesh, layout: VertexLayout) {
    const buffers = new DividedBuffers(device, layout)
    const indices = mesh.indices()
    const vertices = mesh.values(-1).length / 3
    if (!buffers.grow({ vertices, triangles: indices.length / 3 })) {
      buffers.drawn.destroy()
      return undefined
    }
    device.queue.writeBuffer(buffers.indices, 0, indices)
    device.queue.writeBuffer(buffers.vertices, 0, buffers.arrange(mesh))
    device.queue.writeBuffer(buffers.drawn, 0, new Uint32Array([indices.length, 1, 0, 0, 0]))
    return buffers
  }

  /** Replaces the buffers by larger ones. With an encoder, copies the present mesh. Returns `false` if a buffer would be too large. */
  grow({ vertices, triangles }: Room, encoder?: GpuEncoder): boolean {
    const { maxStorageBufferBindingSize, maxBufferSize } = this.device.limits
    const room = {
      vertices: Math.max(growth * vertices, this.room.vertices),
      triangles: Math.max(growth * triangles, this.room.triangles),
    }
    const bytes = [4 * this.layout.stride * room.vertices, 12 * room.triangles] as const
    if (Math.max(...bytes) > Math.min(maxStorageBufferBindingSize, maxBufferSize)) return false
    const before = { vertices: this.vertices, indices: this.indices, room: this.room }
    this.vertices = this.make('vertices', bytes[0], usage.vertex)
    this.indices = this.make('indices', bytes[1], usage.index)
    this.room = room
    if (encoder) this.copy(before, encoder)
    return true
  }

  /** Destroys the buffers that `grow` has replaced, once its commands are submitted. */
  destroyOutgrown() {
    for (const buffer of this.outgrown.splice(0)) buffer.destroy()
  }

  destroy() {
    for (const buffer of [this.vertices, this.indices, this.drawn]) buffer.destroy()
  }

  private copy(
    { vertices, indices, room }: Pick<DividedBuffers, 'vertices' | 'indices' | 'room'>,
    encoder: GpuEncoder,
  ) {
    const { layout } = this
    encoder.copyBufferToBuffer(indices, 0, this.indices, 0, indices.size)
    const parts = layout.isPlanar ? layout.attributes : [{ size: layout.stride }]
    parts.forEach(({ size }, i) => {
      const [from, to] = [room, this.room].map((each) => 4 * layout.startOf(i, each.vertices))
      encoder.copyBufferToBuffer(vertices, from!, this.vertices, to!, 4 * size * room.vertices)
    })
    this.outgrown.push(vertices, indices)
  }

  private make(name: string, size: number, flag: number) {
    const flags = usage.storage | usage.copyTo | usage.copyFrom | flag
    return this.device.createBuffer({ label: `warpjet detail: ${name}`, size, usage: flags })
  }

  /** Returns the values of all attributes of a mesh in the layout of the buffer of vertices. */
  private arrange(mesh: DetailedMesh) {
    const { layout, room } = this
    const array = new Float32Array(layout.stride * room.vertices)
    layout.attributes.forEach(({ size }, attribute) => {
      const values = mesh.values(attribute - 1)
      const step = layout.stepOf(attribute)
      let at = layout.startOf(attribute, room.vertices)
      for (let i = 0; i < values.length; i += size, at += step)
        for (let k = 0; k < size; k++) array[at + k] = values[i + k]!
    })
    return array
  }
}
