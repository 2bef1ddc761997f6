// Runs a program in a WebGPU compute shader. Runs in the page, which must be from localhost: about:blank has no WebGPU.
import { declareInputs, outputVectors, totalSize } from './text.js'

const workgroupSize = 64

/** Returns the number of vec4s for the outputs. SwiftShader writes vec4s faster than floats. */
const countVectors = (outputs) => Math.ceil(totalSize(outputs) / 4)

function computeSource({ code, declarations, inputs, outputs, images }) {
  const [inputFloats, outputVec4s] = [totalSize(inputs), countVectors(outputs)]
  const reads = declareInputs(
    'wgsl',
    inputs,
    (i) => `allInputs[pointIndex * ${inputFloats}u + ${i}u]`,
  )
  const writes = outputVectors('wgsl', outputs, 'vec4f').map(
    (value, i) => `allOutputs[pointIndex * ${outputVec4s}u + ${i}u] = ${value};`,
  )
  return `
@group(0) @binding(0) var<storage, read> allInputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> allOutputs: array<vec4f>;
${Object.keys(images)
  .map((name, i) => `@group(0) @binding(${2 + i}) var ${name}: texture_2d<f32>;`)
  .join('\n')}
${declarations}
@compute @workgroup_size(${workgroupSize})
fn main(@builtin(global_invocation_id) invocation: vec3u) {
let pointIndex = invocation.x;
if (pointIndex >= arrayLength(&allInputs) / ${inputFloats}u) { return; }
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

const createPipeline = (device, source) =>
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
  const pipeline = await createPipeline(device, source)
  return throwErrors(device, source, async () => {
    const bytes = count * countVectors(program.outputs) * 16
    const { STORAGE, COPY_SRC, COPY_DST, MAP_READ } = GPUBufferUsage
    const inputBuffer = device.createBuffer({ size: points.byteLength, usage: STORAGE | COPY_DST })
    const outputBuffer = device.createBuffer({ size: bytes, usage: STORAGE | COPY_SRC })
    const readBuffer = device.createBuffer({ size: bytes, usage: COPY_DST | MAP_READ })
    device.queue.writeBuffer(inputBuffer, 0, points)
    const textures = Object.values(program.images).map((image) => createTexture(device, image))
    const encoder = device.createCommandEncoder()
    const pass = encoder.beginComputePass()
    pass.setPipeline(pipeline)
    pass.setBindGroup(
      0,
      device.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: [
          ...[inputBuffer, outputBuffer].map((buffer) => ({ buffer })),
          ...textures.map((texture) => texture.createView()),
        ].map((resource, binding) => ({ binding, resource })),
      }),
    )
    pass.dispatchWorkgroups(Math.ceil(count / workgroupSize))
    pass.end()
    encoder.copyBufferToBuffer(outputBuffer, 0, readBuffer, 0, bytes)
    device.queue.submit([encoder.finish()])
    await readBuffer.mapAsync(GPUMapMode.READ)
    const results = new Float32Array(readBuffer.getMappedRange().slice())
    for (const resource of [inputBuffer, outputBuffer, readBuffer, ...textures]) resource.destroy()
    return removePadding(results, count, totalSize(program.outputs))
  })
}

function createTexture(device, { width, height, data }) {
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
function removePadding(rows, count, size) {
  const [results, width] = [new Float32Array(count * size), rows.length / count]
  for (let i = 0; i < count; i++) results.set(rows.subarray(i * width, i * width + size), i * size)
  return results
}
