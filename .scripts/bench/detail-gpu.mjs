// npm run bench -- detail-gpu [--edges 100000] [--size 1024] [--frames 40] [--software]: times the compute passes of the option `detail` in
// three.js on WebGPU, with GPU timestamps where supported, and the CPU time of render() with and without these passes.
import { threePagesIn } from '../../tests/support/browser/three/open.js'
import { parseOptions } from '../lib/options.mjs'
import { good, say } from '../lib/terminal.mjs'
import { launchFastest } from './frames/browsers.mjs'

/** The flag of Chromium with which timestamps are not rounded. */
const exactTimes = '--enable-webgpu-developer-features'

export async function measure(args) {
  const { software, ...settings } = parseOptions(
    args,
    { edges: 100_000, size: 1024, frames: 40 },
    { software: { type: 'boolean' } },
  )
  const pages = await threePagesIn(await launchFastest(software, [exactTimes]))
  const { page } = await pages.open('three', 'detail/page-bench.js')
  const { rows, adapter } = await page.evaluate((options) => benchDetail(options), settings)
  await pages.close()
  good(`WebGPU: ${adapter || 'an unnamed adapter'}`)
  say(
    `A sphere of about ${settings.edges} edges, moving; milliseconds, medians of ${settings.frames} frames:`,
  )
  console.table(rows)
}
