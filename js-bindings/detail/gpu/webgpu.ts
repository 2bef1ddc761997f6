// The part of WebGPU that compute passes use. TypeScript's own types lack it.

export interface GpuBuffer {
  readonly size: number
  mapAsync(mode: number): Promise<void>
  getMappedRange(): ArrayBuffer
  unmap(): void
  destroy(): void
}

export interface GpuPipeline {
  getBindGroupLayout(group: number): object
}

export interface GpuEncoder {
  beginComputePass(settings: { label: string }): {
    setPipeline(pipeline: GpuPipeline): void
    setBindGroup(group: number, bindings: object): void
    dispatchWorkgroups(count: number): void
    end(): void
  }
  copyBufferToBuffer(from: GpuBuffer, at: number, to: GpuBuffer, toAt: number, bytes: number): void
  finish(): object
}

export interface GpuDevice {
  readonly limits: {
    readonly maxStorageBufferBindingSize: number
    readonly maxBufferSize: number
    readonly maxStorageBuffersPerShaderStage: number
    readonly maxComputeWorkgroupsPerDimension: number
    readonly maxComputeInvocationsPerWorkgroup: number
  }
  readonly queue: {
    writeBuffer(buffer: GpuBuffer, at: number, values: ArrayBufferView): void
    submit(commands: readonly object[]): void
  }
  createBuffer(settings: { label: string; size: number; usage: number }): GpuBuffer
  createShaderModule(settings: { label: string; code: string }): object
  createComputePipelineAsync(settings: {
    label: string
    layout: 'auto'
    compute: { module: object }
  }): Promise<GpuPipeline>
  createBindGroup(settings: {
    layout: object
    entries: readonly { binding: number; resource: { buffer: GpuBuffer } }[]
  }): object
  createCommandEncoder(settings: { label: string }): GpuEncoder
}

/** The bits of GPUBufferUsage. */
export const usage = {
  mapRead: 1,
  copyFrom: 4,
  copyTo: 8,
  index: 16,
  vertex: 32,
  uniform: 64,
  storage: 128,
  indirect: 256,
}

/** The bit of GPUMapMode. */
export const mapRead = 1
