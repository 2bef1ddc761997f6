/** The buffers of a divided shape on the GPU. */
import type { DetailedMesh } from '../../detail/detailed-mesh.js'
import { usage, type GpuBuffer, type GpuDevice } from '../../detail/gpu/webgpu.js'
import type { Renderer } from '../host.js'
import { drawnIndices, type ShapeBase } from './shape.js'

/** The buffers that p5 keeps for a shape: those of attributes by their name `dst`, and that of indices. */
export type ShapeBuffers = Record<string, unknown>

/** Returns the GPUDevice of a WEBGPU canvas. */
export const deviceOf = ({ device }: Renderer) => device as unknown as GpuDevice | undefined

/** Writes arrays into buffers. Makes buffers that are missing or too small. */
interface Writer {
  attribute(buffers: ShapeBuffers, name: string, values: Float32Array): void
  indices(buffers: ShapeBuffers, values: Uint32Array): void
}

/** Uploads the present arrays of a mesh. */
export function upload(
  renderer: Renderer,
  base: ShapeBase,
  mesh: DetailedMesh,
  buffers: ShapeBuffers,
) {
  const { positionBuffer, buffers: attributeBuffers } = base
  const writer = writerOf(renderer)
  writer.attribute(buffers, positionBuffer, mesh.values(-1))
  attributeBuffers.forEach(({ dst }, i) => writer.attribute(buffers, dst, mesh.values(i)))
  writer.indices(buffers, drawnIndices(base, mesh))
}

const writerOf = (renderer: Renderer) =>
  renderer.device ? writerOfGpu(deviceOf(renderer)!) : writerOfGl(renderer)

/** Uploads arrays of lines, by the names of their buffers. */
export function uploadLines(
  renderer: Renderer,
  arrays: readonly (readonly [name: string, values: Float32Array])[],
  buffers: ShapeBuffers,
) {
  const writer = writerOf(renderer)
  for (const [name, values] of arrays) writer.attribute(buffers, name, values)
}

function writerOfGl(renderer: Renderer): Writer {
  const gl = renderer.GL as unknown as WebGLRenderingContext
  const write = (buffers: ShapeBuffers, name: string, target: number, values: ArrayBufferView) => {
    buffers[name] ??= gl.createBuffer()
    gl.bindBuffer(target, buffers[name] as WebGLBuffer)
    gl.bufferData(target, values, gl.DYNAMIC_DRAW)
  }
  return {
    attribute: (buffers, name, values) => write(buffers, name, gl.ARRAY_BUFFER, values),
    indices(buffers, values) {
      write(buffers, 'indexBuffer', gl.ELEMENT_ARRAY_BUFFER, values)
      buffers.indexBufferType = gl.UNSIGNED_INT
    },
  }
}

function writerOfGpu(device: GpuDevice): Writer {
  const write = (buffers: ShapeBuffers, name: string, values: ArrayBufferView, kind: number) => {
    const { byteLength } = values
    let buffer = buffers[name] as GpuBuffer | undefined
    if (!buffer || buffer.size < byteLength) {
      // The draws of earlier frames are submitted, and a buffer is written once per frame.
      buffer?.destroy()
      // Makes the buffer half larger than necessary, so that it grows rarely.
      const size = 4 * Math.ceil((1.5 * byteLength) / 4)
      const label = `warpjet detail: ${name}`
      buffers[name] = buffer = device.createBuffer({ label, size, usage: kind | usage.copyTo })
    }
    device.queue.writeBuffer(buffer, 0, values)
  }
  return {
    attribute: (buffers, name, values) => write(buffers, name, values, usage.vertex),
    indices(buffers, values) {
      write(buffers, 'indexBuffer', values, usage.index)
      // p5 2.3 writes `indexBufferType` and reads `indexFormat`.
      buffers.indexBufferType = buffers.indexFormat = 'uint32'
    },
  }
}

/** Submits the present draws of p5 on WEBGPU, after which their buffers can be destroyed. */
export function submitDraws(renderer: Renderer) {
  if (deviceOf(renderer)) (renderer as { flushDraw?: () => void }).flushDraw?.()
}

/** Maps a renderer → the frame of its last draw with detail. */
const lastFrames = new WeakMap<Renderer, number>()

/** Submits the draws of earlier frames, whose buffers may be written or destroyed in this one. `redraw(n)` submits n frames at once. */
export function submitEarlierFrames(renderer: Renderer, frame: number) {
  if (lastFrames.get(renderer) !== frame) submitDraws(renderer)
  lastFrames.set(renderer, frame)
}

/** Destroys buffers of WEBGPU. The draws that read them must have been submitted. */
export function destroyOnGpu(buffers: ShapeBuffers) {
  for (const [name, buffer] of Object.entries(buffers)) {
    if (name === 'geometry' || !(buffer as Partial<GpuBuffer>).destroy) continue
    ;(buffer as GpuBuffer).destroy()
    delete buffers[name]
  }
}
