// A WebGPU compute shader. Runs in the page, which must be from localhost: about:blank has no WebGPU.
import { declareInputs, outputVectors, totalSize } from './text.js'

const group = 64

/** The number of vec4s for the outputs, which SwiftShader writes faster than floats. */
const vectorCount = (outputs) => Math.ceil(totalSize(outputs) / 4)

function computeSource({ code, declarations, inputs, outputs, images }) {
  const [given, taken] = [totalSize(inputs), vectorCount(outputs)]
  const reads = declareInputs('wgsl', inputs, (i) => `allInputs[pointIndex * ${given}u + ${i}u]`)
  const writes = outputVectors('wgsl', outputs, 'vec4f').map(
    (value, i) => `allOutputs[pointIndex * ${taken}u + ${i}u] = ${value};`,
  )
  return `
@group(0) @binding(0) var<storage, read> allInputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> allOutputs: array<vec4f>;
${Object.keys(images)
  .map((name, i) => `@group(0) @binding(${2 + i}) var ${name}: texture_2d<f32>;`)
  .join('\n')}
${declarations}
@compute @workgroup_size(${group})
fn main(@builtin(global_invocation_id) invocation: vec3u) {
let pointIndex = invocation.x;
if (pointIndex >= arrayLength(&allInputs) / ${given}u) { return; }
${reads}
${code}
${writes.join('\n')}
}`
}

export async function open() {
  const adapter = await navigator.gpu?.requestAdapter()
  if (!adapter) throw new Error('WebGPU is not available.')
  const device = await adapter.requestDevice()
  return (program, points) => run(device, program, points)
}

/** Runs `work`, and throws WebGPU's errors with the source. */
async function throwErrors(device, source, work) {
  device.pushErrorScope('validation')
  const [outcome] = await Promise.allSettled([work()])
  const invalid = await device.popErrorScope()
  const error = outcome.reason ?? invalid
  if (error) throw new Error(`${error.message}\n${source}`)
  return outcome.value
}

const pipelineOf = (device, source) =>
  throwErrors(device, source, async () => {
    const module = device.createShaderModule({ code: source })
    const { messages } = await module.getCompilationInfo()
    const errors = messages.filter(({ type }) => type === 'error')
    const lines = errors.map(({ lineNum, message }) => `line ${lineNum}: ${message}`)
    if (errors.length) throw new Error(lines.join('\n'))
    return device.createComputePipeline({ layout: 'auto', compute: { module } })
  })

async function run(device, program, points) {
  const count = points.length / totalSize(program.inputs)
  const source = computeSource(program)
  const pipeline = await pipelineOf(device, source)
  return throwErrors(device, source, async () => {
    const bytes = count * vectorCount(program.outputs) * 16
    const { STORAGE, COPY_SRC, COPY_DST, MAP_READ } = GPUBufferUsage
    const given = device.createBuffer({ size: points.byteLength, usage: STORAGE | COPY_DST })
    const taken = device.createBuffer({ size: bytes, usage: STORAGE | COPY_SRC })
    const read = device.createBuffer({ size: bytes, usage: COPY_DST | MAP_READ })
    device.queue.writeBuffer(given, 0, points)
    const textures = Object.values(program.images).map((image) => textureOf(device, image))
    const encoder = device.createCommandEncoder()
    const pass = encoder.beginComputePass()
    pass.setPipeline(pipeline)
    pass.setBindGroup(
      0,
      device.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: [
          ...[given, taken].map((buffer) => ({ buffer })),
          ...textures.map((texture) => texture.createView()),
        ].map((resource, binding) => ({ binding, resource })),
      }),
    )
    pass.dispatchWorkgroups(Math.ceil(count / group))
    pass.end()
    encoder.copyBufferToBuffer(taken, 0, read, 0, bytes)
    device.queue.submit([encoder.finish()])
    await read.mapAsync(GPUMapMode.READ)
    const results = new Float32Array(read.getMappedRange().slice())
    for (const resource of [given, taken, read, ...textures]) resource.destroy()
    return withoutPadding(results, count, totalSize(program.outputs))
  })
}

function textureOf(device, { width, height, data }) {
  const { COPY_DST, TEXTURE_BINDING } = GPUTextureUsage
  const texture = device.createTexture({
    size: [width, height],
    format: 'rgba8unorm',
    usage: COPY_DST | TEXTURE_BINDING,
  })
  const layout = { bytesPerRow: 4 * width }
  device.queue.writeTexture({ texture }, Uint8Array.from(data), layout, [width, height])
  return texture
}

/** Returns the first `size` floats of each of `count` rows. */
function withoutPadding(rows, count, size) {
  const [results, width] = [new Float32Array(count * size), rows.length / count]
  for (let i = 0; i < count; i++) results.set(rows.subarray(i * width, i * width + size), i * size)
  return results
}
