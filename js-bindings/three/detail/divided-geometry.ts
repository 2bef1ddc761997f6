/** The geometry that is drawn in place of the user's. Its buffers have room for more vertices, and are written when the division changes. */
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three'
import type { DetailedMesh } from '../../detail/detailed-mesh.js'
import type { Column, GeometryBase } from './base.js'
import { addGroups } from './drawn-surface.js'

/** One buffer of the GPU. */
type Buffer = BufferAttribute | InterleavedBuffer

export class DividedGeometry {
  geometry = new BufferGeometry()
  private buffers: { readonly columns: readonly Column[]; readonly buffer: Buffer }[] = []
  private index = new BufferAttribute(new Uint32Array(), 1)
  private vertices = 0
  /** The version of the mesh whose arrays it has; 0 for none. */
  private version = 0

  /** `own` is the user's geometry. */
  constructor(
    private readonly base: GeometryBase,
    private readonly own: BufferGeometry,
  ) {}

  /** Copies the arrays of the divided mesh, if they have changed. */
  write(mesh: DetailedMesh) {
    if (mesh.version === this.version) return
    const vertices = mesh.values(-1).length / 3
    const triangles = mesh.indices()
    const indices = triangles.length
    if (vertices > this.vertices || indices > this.index.count) this.grow(vertices, indices)
    for (const { columns, buffer } of this.buffers) {
      const stride = sizeOf(columns)
      let offset = 0
      for (const { attribute, size } of columns) {
        copy(mesh.values(attribute), size, buffer.array as Float32Array, offset, stride)
        offset += size
      }
      markChanged(buffer, stride * vertices)
    }
    ;(this.index.array as Uint32Array).set(mesh.indices())
    markChanged(this.index, indices)
    this.geometry.setDrawRange(0, indices)
    addGroups(this.geometry, this.base, mesh)
    this.version = mesh.version
  }

  dispose() {
    if (!this.vertices) return
    // Disposing of a geometry frees its attributes, but the attributes of instances belong to the user.
    for (const name of Object.keys(this.base.ofInstances)) this.geometry.deleteAttribute(name)
    this.geometry.dispose()
    this.vertices = this.version = 0
    this.index = new BufferAttribute(new Uint32Array(), 1)
  }

  /** Makes larger buffers. Buffers of a geometry cannot grow, so this makes another geometry. */
  private grow(vertices: number, indices: number) {
    this.dispose()
    this.vertices = capacityFor(vertices)
    const { base, own } = this
    const geometry = (this.geometry = new BufferGeometry())
    if (!own.boundingSphere) own.computeBoundingSphere()
    Object.assign(geometry, { name: own.name, userData: own.userData })
    Object.assign(geometry, { boundingSphere: own.boundingSphere, boundingBox: own.boundingBox })
    this.buffers = base.buffers.map((columns) => {
      const stride = sizeOf(columns)
      const array = new Float32Array(stride * this.vertices)
      const buffer =
        columns.length > 1
          ? new InterleavedBuffer(array, stride)
          : new BufferAttribute(array, stride)
      let offset = 0
      for (const { name, size } of columns) {
        geometry.setAttribute(
          name,
          buffer instanceof InterleavedBuffer
            ? new InterleavedBufferAttribute(buffer, size, offset)
            : buffer,
        )
        offset += size
      }
      return { columns, buffer: buffer.setUsage(DynamicDrawUsage) }
    })
    for (const [name, attribute] of Object.entries(base.ofInstances))
      geometry.setAttribute(name, attribute)
    this.index = new BufferAttribute(new Uint32Array(capacityFor(indices)), 1)
    geometry.setIndex(this.index.setUsage(DynamicDrawUsage))
  }
}

const sizeOf = (columns: readonly Column[]) => columns.reduce((sum, { size }) => sum + size, 0)

const capacityFor = (count: number) => 2 ** Math.ceil(Math.log2(Math.max(count, 1)))

function copy(from: Float32Array, size: number, to: Float32Array, offset: number, stride: number) {
  if (size === stride) {
    to.set(from)
    return
  }
  for (let i = 0, at = offset; i < from.length; i += size, at += stride)
    for (let k = 0; k < size; k++) to[at + k] = from[i + k]!
}

/** Lets three.js upload the first `count` numbers. */
function markChanged(buffer: Buffer, count: number) {
  buffer.clearUpdateRanges()
  buffer.addUpdateRange(0, count)
  buffer.needsUpdate = true
}
