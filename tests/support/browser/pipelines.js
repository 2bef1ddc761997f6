// Runs compiled code on the real GPU pipelines of a browser, and returns the computed float32 numbers: `glsl100` in WebGL 1,
// `glsl300` in WebGL 2, `wgsl` in WebGPU.
import { isRun } from '../../../.scripts/lib/tiers.mjs'
import { launchBrowser, openPage, webgpuFlags } from './browser.js'
import { servePages } from './server.js'

/** Maps a language → the module that runs it. */
const modules = { glsl300: 'webgl2', glsl100: 'webgl1', wgsl: 'webgpu' }

const html = `<!doctype html>
<meta charset="utf-8">
<script type="module">
const modules = ${JSON.stringify(modules)}
const opened = {}
async function pipeline(target) {
  const { open } = await import('/tests/support/browser/pipelines/' + modules[target] + '.js')
  return open()
}
const last = {}
window.run = async (target, program, points) => {
  const work = await (opened[target] ??= pipeline(target))
  // Programs run one after the other: WebGL and WebGPU would report an error to the first program that queries errors.
  const running = (last[target] ?? Promise.resolve())
    .catch(() => {})
    .then(() => work(program, new Float32Array(Uint8Array.fromBase64(points).buffer)))
  last[target] = running
  const results = await running
  return new Uint8Array(results.buffer).toBase64()
}
</script>`

/** The languages that have pipelines. */
export const targets = Object.keys(modules)

/** The languages whose results this run of the tests compares with references. */
export const targetsInThisRun = targets.filter(
  (target) => target === 'glsl300' || isRun('all dialects'),
)

/**
 * Starts a browser. Returns { run, close }.
 *
 * `run(target, program, points)` runs a program at many points at once. The program is { code, declarations, inputs, outputs, images }.
 * `images`, which is optional, maps names to { width, height, data }, with four bytes per texel. Inputs are the variables that the code
 * reads, outputs those that it declares: lists of { name, shape }, where `shape` is 1 for a number, 2 to 4 for vectors, 'mat2' to 'mat4'
 * (column-major), or 'bool' (1 or 0). A point is a list of the floats of all inputs; its result is a Float32Array of the floats of all
 * outputs. `run` throws if the browser has no such pipeline, or, with the compiler's log and the whole shader, if the code does not
 * compile.
 */
export async function openPipelines() {
  const browser = await launchBrowser(webgpuFlags)
  const server = await servePages()
  const { page } = await openPage(browser, server.page(html))
  await page.waitForFunction(() => window.run)

  async function run(target, { code, declarations, inputs, outputs, images = {} }, points) {
    const inputFloats = Float32Array.from(points.flat())
    const base64 = await page.evaluate(
      ([target, program, points]) => window.run(target, program, points),
      [
        target,
        { code, declarations, inputs, outputs, images },
        Buffer.from(inputFloats.buffer).toString('base64'),
      ],
    )
    const results = new Float32Array(Uint8Array.from(Buffer.from(base64, 'base64')).buffer)
    const size = results.length / points.length
    return points.map((_, i) => results.subarray(i * size, (i + 1) * size))
  }

  async function close() {
    await browser.close()
    await server.close()
  }
  return { run, close }
}
