// npm run bench -- nodes [--size 1200] [--pieces N] [--pages 5] [--rounds 15] [--batch 50] [--software] [--backend webgl|webgpu]:
// measures two of three's showcases on both backends of WebGPURenderer: as they are, with normals by hand, and by exactNormals. A row has
// - the median frame and its ratio to the original's, measured in turn, with one pixel read after each batch;
// - the median first frame of `pages` new pages, and how much longer it takes than the original's;
// - the evaluations of the height in the vertex + in the fragment shader, where a loop of octaves counts once for each call;
// - the characters of the vertex + of the fragment shader.
// The colour of the sea needs one evaluation in each fragment shader. Each side of a plane is split into `pieces`.
import { parseArgs } from 'node:util'
import { chromium } from 'playwright-core'
import { webgpuFlags } from '../../tests/support/browser/browser.js'
import { threePagesIn } from '../../tests/support/browser/three/open.js'
import { median } from '../lib/median.mjs'
import { Stop, good, say } from '../lib/terminal.mjs'
import { chooseRenderer } from './frames/browsers.mjs'

const numericOptions = { size: '1200', pieces: undefined, pages: '5', rounds: '15', batch: '50' }

function readOptions(args) {
  const { values } = parseArgs({
    args,
    options: {
      ...Object.fromEntries(
        Object.entries(numericOptions).map(([name, defaultValue]) => [
          name,
          { type: 'string', ...(defaultValue && { default: defaultValue }) },
        ]),
      ),
      software: { type: 'boolean', default: false },
      backend: { type: 'string' },
    },
  })
  for (const name of Object.keys(numericOptions).filter((name) => values[name] !== undefined)) {
    const number = Number(values[name])
    if (!(Number.isInteger(number) && number > 0))
      throw new Stop(`Expected a positive whole number for --${name}, got ${values[name]}.`)
    values[name] = number
  }
  return values
}

const round = (x) => Number(x.toPrecision(3))

export async function measure(args) {
  const { software, backend: chosenBackend, ...options } = readOptions(args)
  const launch = (flags) =>
    chromium.launch({ executablePath: process.env.WARPJET_CHROMIUM, args: flags })
  const { flags, renderer, isSoftware } = await chooseRenderer(launch, software)
  good(`${isSoftware ? 'No GPU' : 'GPU'}: ${renderer}`)
  const browser = await launch([
    ...flags,
    ...(isSoftware ? webgpuFlags : ['--enable-unsafe-webgpu', '--enable-features=Vulkan']),
  ])
  const pages = await threePagesIn(browser)
  try {
    for (const backend of chosenBackend ? [chosenBackend] : ['webgl', 'webgpu'])
      for (const name of ['sea', 'terrain']) {
        say(`${name}, ${backend}, milliseconds:`)
        console.table(await measureRows(pages, name, backend, options))
      }
  } finally {
    await pages.close()
  }
}

async function measureRows(pages, name, backend, { size, pieces, pages: count, rounds, batch }) {
  let salt = 0
  async function runInNewPage(work, ...args) {
    const { page } = await pages.open('three', 'exact-normals/page-bench.js')
    try {
      await page.evaluate((args) => bench.open(...args), [backend, size])
      return await page.evaluate(work, args)
    } finally {
      await page.close()
    }
  }
  const rows = await runInNewPage((args) => bench.frames(...args), name, { pieces, rounds, batch })
  const firstFrames = rows.map(() => [])
  for (let i = 0; i < count; i++)
    for (const [k, { mode }] of rows.entries()) {
      const options = { pieces, salt: 1e-6 * ++salt }
      firstFrames[k].push(await runInNewPage((args) => bench.first(...args), name, mode, options))
    }
  return rows.map(({ mode, frame, ratio, heights, characters }, k) => ({
    mode,
    frame: round(frame),
    ratio: round(ratio),
    'first frame': round(median(firstFrames[k])),
    'more than the original': round(median(firstFrames[k]) - median(firstFrames[0])),
    'heights, vertex + fragment': heights,
    'characters, vertex + fragment': characters,
  }))
}
