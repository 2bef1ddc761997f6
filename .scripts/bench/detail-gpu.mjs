// npm run bench -- detail-gpu [--edges 100000] [--size 1024] [--frames 40] [--software]: times the compute passes of the option `detail` in
// three.js on WebGPU, by timestamps of the GPU where it supports them, and the CPU time of render() with and without these passes.
import { parseArgs } from 'node:util'
import { chromium } from 'playwright-core'
import { webgpuFlags } from '../../tests/support/browser/browser.js'
import { threePagesIn } from '../../tests/support/browser/three/open.js'
import { gpuFlags, softwareFlags } from '../lib/flags.mjs'
import { Stop, good, say } from '../lib/terminal.mjs'

/** The flag with which timestamps are not rounded. */
const exactTimes = '--enable-webgpu-developer-features'

/** Runs in the page: tests whether WebGPU draws on a GPU. */
async function hasGpu() {
  const adapter = await navigator.gpu?.requestAdapter()
  return adapter !== null && adapter !== undefined && !adapter.info.isFallbackAdapter
}

async function launch(isSoftware) {
  const executablePath = process.env.WARPJET_CHROMIUM
  if (!isSoftware) {
    const args = [...gpuFlags, '--enable-unsafe-webgpu', exactTimes]
    const browser = await chromium.launch({ executablePath, args })
    const pages = await threePagesIn(browser)
    const { page } = await pages.open('three', 'detail/page-bench.js').catch(() => ({}))
    if (await page?.evaluate(hasGpu)) return { pages, page }
    await pages.close()
  }
  const args = [...softwareFlags, ...webgpuFlags, '--use-vulkan=swiftshader', exactTimes]
  const pages = await threePagesIn(await chromium.launch({ executablePath, args }))
  return { pages, ...(await pages.open('three', 'detail/page-bench.js')) }
}

export async function measure(args) {
  const { values } = parseArgs({
    args,
    options: {
      edges: { type: 'string', default: '100000' },
      size: { type: 'string', default: '1024' },
      frames: { type: 'string', default: '40' },
      software: { type: 'boolean', default: false },
    },
  })
  const settings = Object.fromEntries(
    ['edges', 'size', 'frames'].map((name) => [name, Number(values[name])]),
  )
  for (const [name, value] of Object.entries(settings))
    if (!(Number.isInteger(value) && value > 0))
      throw new Stop(`Expected a whole number above 0 for --${name}, got ${values[name]}.`)
  const { pages, page } = await launch(values.software)
  const { rows, adapter } = await page.evaluate((options) => benchDetail(options), settings)
  await pages.close()
  good(`WebGPU: ${adapter || 'an unnamed adapter'}`)
  say(
    `A sphere of about ${settings.edges} edges, moving; milliseconds, medians of ${settings.frames} frames:`,
  )
  console.table(rows)
}
