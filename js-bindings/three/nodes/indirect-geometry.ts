/** A geometry of three.js with the buffers that compute passes write. */
import {
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three'
import { IndirectStorageBufferAttribute } from 'three/webgpu'
import type { DividedBuffers } from '../../detail/gpu/divided-buffers.js'
import type { GpuBuffer, GpuDevice } from '../../detail/gpu/webgpu.js'
import type { GeometryBase } from '../detail/base.js'

/** The part of the backend that is used here. It stores the buffer of an attribute as `buffer`, and creates one only if that is missing. */
export interface Backend {
  readonly isWebGPUBackend?: boolean
  readonly device: GpuDevice
  get(attribute: object): { buffer?: GpuBuffer }
}

/** Returns a geometry whose vertices, indices and draw arguments are the buffers of the compute passes. `original` is the user's geometry. */
export function indirectGeometry(
  backend: Backend,
  base: GeometryBase,
  original: BufferGeometry,
  { layout, vertices, indices, drawn }: DividedBuffers,
): BufferGeometry {
  const geometry = new BufferGeometry()
  const { name, userData, boundingSphere, boundingBox } = original
  Object.assign(geometry, { name, userData, boundingSphere, boundingBox })
  const { stride, before } = layout
  // The arrays only tell three.js the types of numbers.
  const interleaved = new InterleavedBuffer(new Float32Array(stride), stride)
  backend.get(interleaved).buffer = vertices
  for (const { name, size, attribute } of base.buffers.flat()) {
    const offset = before[attribute + 1]!
    geometry.setAttribute(name, new InterleavedBufferAttribute(interleaved, size, offset))
  }
  for (const [name, attribute] of Object.entries(base.ofInstances))
    geometry.setAttribute(name, attribute)
  const index = new BufferAttribute(new Uint32Array(3), 1)
  backend.get(index).buffer = indices
  const indirect = new IndirectStorageBufferAttribute(new Uint32Array(5), 1)
  backend.get(indirect).buffer = drawn
  return geometry.setIndex(index).setIndirect(indirect as never)
}

/** Makes three.js forget the geometry, but not the buffers of instances, which belong to the user's geometry. */
export function disposeIndirect(geometry: BufferGeometry, { ofInstances }: GeometryBase) {
  for (const name of Object.keys(ofInstances)) geometry.deleteAttribute(name)
  geometry.dispose()
}
