// Tests that functions in WGSL have the same values as in a compute shader of Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { wgslOffset } from '../../dist/glsl.js'
import { compileWarp } from '../../dist/warpjet.js'
import { launchBrowser, openPage, webgpuFlags } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'
import { ownFunctions } from '../wgsl/own.js'

let browser, server, page
before(async () => {
  server = await servePages()
  browser = await launchBrowser(webgpuFlags)
  ;({ page } = await openPage(browser, server.page('<!doctype html><meta charset="utf-8">')))
})
after(async () => {
  await browser.close()
  await server.close()
})

const points = [
  [0.3, 0.7, -0.2],
  [-0.6, 0.1, 0.9],
  [0.9, -0.8, 0.4],
  [-0.2, -0.4, 0.5],
  [0.05, 0.95, 0.65],
  [-0.95, 0.25, -0.55],
]

/** Returns a compute shader with the source; `call` writes the value at each point. */
const computeShader = (text, call) => `${text}
@group(0) @binding(0) var<storage, read> pointsIn: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> valuesOut: array<vec4f>;
@compute @workgroup_size(1) fn computeValues(@builtin(global_invocation_id) at: vec3u) {
  let point = pointsIn[at.x].xyz;
  ${call}
}`

const browserValues = (shaders) =>
  page.evaluate(
    async ([shaders, points]) => {
      const device = await (await navigator.gpu.requestAdapter()).requestDevice()
      const size = points.length * 16
      const { STORAGE, COPY_SRC, COPY_DST, MAP_READ } = GPUBufferUsage
      const inputBuffer = device.createBuffer({ size, usage: STORAGE | COPY_DST })
      device.queue.writeBuffer(inputBuffer, 0, new Float32Array(points.flatMap((p) => [...p, 0])))
      const all = []
      for (const code of shaders) {
        device.pushErrorScope('validation')
        const outputBuffer = device.createBuffer({ size, usage: STORAGE | COPY_SRC })
        const readbackBuffer = device.createBuffer({ size, usage: COPY_DST | MAP_READ })
        const module = device.createShaderModule({ code })
        const pipeline = device.createComputePipeline({
          layout: 'auto',
          compute: { module, entryPoint: 'computeValues' },
        })
        const encoder = device.createCommandEncoder()
        const pass = encoder.beginComputePass()
        pass.setPipeline(pipeline)
        const entries = [inputBuffer, outputBuffer].map((buffer, binding) => ({
          binding,
          resource: { buffer },
        }))
        pass.setBindGroup(
          0,
          device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }),
        )
        pass.dispatchWorkgroups(points.length)
        pass.end()
        encoder.copyBufferToBuffer(outputBuffer, 0, readbackBuffer, 0, size)
        device.queue.submit([encoder.finish()])
        const error = await device.popErrorScope()
        if (error) throw new Error(`${error.message}\n${code}`)
        await readbackBuffer.mapAsync(MAP_READ)
        all.push([...new Float32Array(readbackBuffer.getMappedRange())])
      }
      device.destroy()
      return all.map((values) => points.map((_, i) => values.slice(4 * i, 4 * i + 3)))
    },
    [shaders, points],
  )

/** Compares with a tolerance: sines in WGSL have an error of up to 2^-11, and so have numbers that are rounded to 16 bits. */
const isNear = (ours, theirs) =>
  Math.abs(ours - theirs) <= 1e-3 + 2e-7 * Math.abs(theirs) ||
  (Number.isNaN(ours) && Number.isNaN(theirs))

test('functions have the same values as in a browser', async () => {
  const theirs = await browserValues(
    Object.values(ownFunctions).map((text) =>
      computeShader(text, 'valuesOut[at.x] = vec4f(own(point), 0);'),
    ),
  )
  const different = Object.entries(ownFunctions).flatMap(([name, text], k) => {
    const warp = compileWarp(wgslOffset(text, { function: 'own', maxIterations: 16 }), {
      normals: false,
    })
    return points.flatMap((p, i) => {
      const moved = warp.evaluateAt(p, { normal: [0, 1, 0] }).position
      const ours = Array.from(moved, (x, c) => x - p[c])
      const areNear = ours.every((x, c) => isNear(x, theirs[k][i][c]))
      return areNear ? [] : [`${name} at ${p}: ${ours}, not ${theirs[k][i]}`]
    })
  })
  assert.deepEqual(different, [])
})

test('the WGSL that we write has the same values', async () => {
  const sources = Object.entries(ownFunctions).map(([, text]) => {
    const { code, declarations } = compileWarp(
      wgslOffset(text, { function: 'own', maxIterations: 16 }),
      { target: 'wgsl', names: { position: 'point' }, normals: false },
    )
    return computeShader(
      `${text.replace(/@(?:vertex|fragment)[^]*/, '')}\n${declarations}`,
      `${code}\n  valuesOut[at.x] = vec4f(offset, 0);`,
    )
  })
  const theirs = await browserValues(
    Object.values(ownFunctions).map((text) =>
      computeShader(text, 'valuesOut[at.x] = vec4f(own(point), 0);'),
    ),
  )
  const ours = await browserValues(sources)
  const different = Object.keys(ownFunctions).flatMap((name, k) =>
    points.flatMap((p, i) =>
      ours[k][i].every((x, c) => isNear(x, theirs[k][i][c]))
        ? []
        : [`${name} at ${p}: ${ours[k][i]}, not ${theirs[k][i]}`],
    ),
  )
  assert.deepEqual(different, [])
})
