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

/** The part of the backend that is used here. It keeps the buffer of an attribute as `buffer`, and makes one only if there is none. */
export interface Backend {
  readonly isWebGPUBackend?: boolean
  readonly device: GpuDevice
  get(attribute: object): { buffer?: GpuBuffer }
}

/** `own` is the user's geometry. */
export function indirectGeometry(
  backend: Backend,
  base: GeometryBase,
  own: BufferGeometry,
  { layout, vertices, indices, drawn }: DividedBuffers,
): BufferGeometry {
  const geometry = new BufferGeometry()
  const { name, userData, boundingSphere, boundingBox } = own
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

/** Makes three.js forget the geometry. The buffers of instances are the user's. */
export function disposeIndirect(geometry: BufferGeometry, { ofInstances }: GeometryBase) {
  for (const name of Object.keys(ofInstances)) geometry.deleteAttribute(name)
  geometry.dispose()
}
