// A mesh that compute passes divide for each frame. It takes over from a `DetailedMesh`, which the CPU has divided.
import type { DrawValues } from '../../compile/offset-warp.js'
import { areEqual } from '../arrays.js'
import type { DetailParts, DetailViews, DetailedMesh } from '../detailed-mesh.js'
import { makeBaseBuffers, type BaseBuffers } from './base-buffers.js'
import {
  blockSize,
  groupSize,
  lanes,
  parameterNames,
  parametersBytes,
  stateNames,
  type Counts,
} from './common-wgsl.js'
import { DividedBuffers, type Room } from './divided-buffers.js'
import type { PassName, Passes } from './passes.js'
import { mapRead, usage, type GpuBuffer, type GpuDevice, type GpuEncoder } from './webgpu.js'

/** The count of numbers of a view in `DetailViews`, and in the struct `View`, which is padded. */
const [viewSize, paddedViewSize] = [19, 20]

export class ComputeDivision {
  /** Changes when the buffers of `divided` are replaced. */
  version = 0
  /** `true` if the mesh needs more memory than a buffer can have. */
  isTooLarge = false
  private readonly groupCounts: Readonly<Record<PassName, number>>
  private readonly parameters: GpuBuffer
  private readonly inputs: GpuBuffer
  private readonly countsToRead: GpuBuffer
  private views = { array: new Float32Array(), buffer: undefined as GpuBuffer | undefined }
  private bindings: Readonly<Record<PassName, object>> | undefined
  /** The numbers that the last run depended on. */
  private lastInputs: readonly number[] = []
  private isReading = false
  /** `true` if the counts of the last run were not read, since those of an earlier run were still being read. */
  private isUnread = false
  /** The room that the last run needed but did not have. */
  private neededRoom: Room | undefined

  private constructor(
    private readonly device: GpuDevice,
    private readonly passes: Passes,
    private readonly counts: Counts,
    private readonly base: BaseBuffers,
    readonly divided: DividedBuffers,
  ) {
    const { samples, triangles, edges, sides } = counts
    const items = sides + triangles
    this.groupCounts = {
      evaluate: Math.ceil(samples / groupSize),
      measure: Math.ceil(triangles / groupSize),
      choose: Math.ceil(edges / groupSize),
      place: Math.ceil(items / blockSize),
      total: 1,
      write: Math.ceil((items * lanes) / blockSize),
    }
    this.parameters = this.make('parameters', parametersBytes, usage.uniform | usage.copyTo)
    const { byteLength } = passes.numbers.array
    this.inputs = this.make('inputs', byteLength, usage.uniform | usage.copyTo)
    this.countsToRead = this.make('counts', 4 * stateNames.length, usage.mapRead | usage.copyTo)
  }

  /** Returns `undefined` if the mesh is too large, empty or curved. */
  static of(device: GpuDevice, passes: Passes, mesh: DetailedMesh, parts: DetailParts) {
    const { vertices, triangles, sides, pieces, samples } = parts
    if (parts.isCurved || triangles === 0) return undefined
    const base = makeBaseBuffers(device, passes, parts)
    const divided = base && DividedBuffers.copyOf(device, mesh, passes.layout)
    if (!divided) {
      if (base) destroyAll(base)
      return undefined
    }
    const counts = {
      ...{
        vertices,
        triangles,
        sides,
        edges: pieces.length,
        samples: samples.positions.length / 3,
      },
      ...{ views: 0, instances: 1, maxVertices: 0, maxTriangles: 0 },
    }
    const division = new ComputeDivision(device, passes, counts, base, divided)
    const { maxComputeWorkgroupsPerDimension } = device.limits
    if (Math.max(...Object.values(division.groupCounts)) <= maxComputeWorkgroupsPerDimension)
      return division
    division.destroy()
    return undefined
  }

  /** Divides the mesh for the draws that are submitted next. `state` are the numbers that the warped samples depend on. */
  update(
    given: DrawValues,
    state: readonly number[],
    views: DetailViews,
    tolerance: number,
    instances: number,
  ) {
    const { neededRoom } = this
    const now = [tolerance, instances, state.length, ...state, ...views]
    const mustRead = this.isUnread && !this.isReading
    if (!neededRoom && !mustRead && areEqual(now, this.lastInputs)) return
    this.lastInputs = now
    const encoder = this.device.createCommandEncoder({ label: 'warpjet detail' })
    if (neededRoom) this.grow(neededRoom, encoder)
    this.writeInputs(given, views, tolerance, instances)
    const bindings = (this.bindings ??= this.bind())
    const pass = encoder.beginComputePass({ label: 'warpjet detail' })
    for (const [name, pipeline] of Object.entries(this.passes.pipelines)) {
      pass.setPipeline(pipeline)
      pass.setBindGroup(0, bindings[name as PassName])
      pass.dispatchWorkgroups(this.groupCounts[name as PassName])
    }
    pass.end()
    if (!this.isReading)
      encoder.copyBufferToBuffer(this.base.state, 0, this.countsToRead, 0, this.countsToRead.size)
    this.device.queue.submit([encoder.finish()])
    this.divided.destroyOutgrown()
    this.isUnread = this.isReading
    if (!this.isReading) void this.readCounts()
  }

  destroy() {
    destroyAll(this.base)
    this.divided.destroy()
    for (const buffer of [this.parameters, this.inputs, this.countsToRead, this.views.buffer])
      buffer?.destroy()
  }

  private writeInputs(given: DrawValues, views: DetailViews, tolerance: number, instances: number) {
    const { queue } = this.device
    const { numbers } = this.passes
    numbers.update(given)
    queue.writeBuffer(this.inputs, 0, numbers.array)
    const count = views.length / viewSize
    this.reserveViews(count)
    for (let i = 0; i < count; i++)
      for (let k = 0; k < viewSize; k++)
        this.views.array[paddedViewSize * i + k] = views[viewSize * i + k]!
    queue.writeBuffer(this.views.buffer!, 0, this.views.array)
    const { vertices: maxVertices, triangles: maxTriangles } = this.divided.room
    const counts = { ...this.counts, views: count, instances, maxVertices, maxTriangles }
    const parameters = new Uint32Array(parametersBytes / 4)
    parameterNames.forEach((name, i) => (parameters[i] = counts[name]))
    new Float32Array(parameters.buffer)[parameterNames.length] = tolerance
    queue.writeBuffer(this.parameters, 0, parameters)
  }

  private reserveViews(count: number) {
    const length = paddedViewSize * count
    if (this.views.array.length >= length) return
    this.views.buffer?.destroy()
    const array = new Float32Array(length)
    const buffer = this.make('views', array.byteLength, usage.storage | usage.copyTo)
    this.views = { array, buffer }
    this.bindings = undefined
  }

  private grow(room: Room, encoder: GpuEncoder) {
    this.neededRoom = undefined
    this.isTooLarge = !this.divided.grow(room, encoder)
    if (this.isTooLarge) return
    this.bindings = undefined
    this.version++
  }

  /** Sets `neededRoom` if the last run needed more room than there is. */
  private async readCounts() {
    this.isReading = true
    try {
      await this.countsToRead.mapAsync(mapRead)
      const [isStale, , vertices, triangles] = new Uint32Array(this.countsToRead.getMappedRange())
      this.countsToRead.unmap()
      if (isStale) this.neededRoom = { vertices: vertices!, triangles: triangles! }
    } catch {
      // The buffer or the device is gone.
    }
    this.isReading = false
  }

  private bind(): Record<PassName, object> {
    const { parameters, inputs, passes, base, divided } = this
    const { samples, warped, topology, needs, pieces, sums, state } = base
    const { table, pipelines } = passes
    const buffers: Record<PassName, GpuBuffer[]> = {
      evaluate: [inputs, samples, warped],
      measure: [this.views.buffer!, topology, base.base, warped, needs, state],
      choose: [needs, pieces, state],
      place: [topology, pieces, table, sums],
      total: [sums, state, divided.drawn],
      write: [
        ...[topology, pieces, table, sums, state, base.base],
        ...[divided.vertices, divided.indices],
      ],
    }
    const bindings = Object.entries(buffers).map(([name, list]) => [
      name,
      this.device.createBindGroup({
        layout: pipelines[name as PassName].getBindGroupLayout(0),
        entries: [parameters, ...list].map((buffer, binding) => ({
          binding,
          resource: { buffer },
        })),
      }),
    ])
    return Object.fromEntries(bindings) as Record<PassName, object>
  }

  private make(name: string, size: number, flags: number) {
    return this.device.createBuffer({ label: `warpjet detail: ${name}`, size, usage: flags })
  }
}

function destroyAll(buffers: BaseBuffers) {
  for (const buffer of Object.values(buffers)) buffer.destroy()
}
