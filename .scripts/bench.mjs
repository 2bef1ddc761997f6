// npm run bench: measures a frame with each method of drawing a warped mesh, in headless Chromium; --help lists the options.
// npm run bench -- evaluate | glsl | gpu | nodes | pixels | three: other benchmarks.
import { resolve } from 'node:path'
import { checkColumns } from './bench/csv.mjs'
import { helpText, readOptions } from './bench/options.mjs'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const others = ['evaluate', 'glsl', 'gpu', 'nodes', 'pixels', 'three']

await main(async () => {
  const args = process.argv.slice(2)
  if (others.includes(args[0])) {
    process.env.WARPJET_CHROMIUM = (await setup()).chromium
    await build()
    const { measure } = await import(`./bench/${args[0]}.mjs`)
    return measure(args.slice(1))
  }
  const { workloads } = await import('../web/bench/workloads.js')
  const rows = workloads.map(({ name }) => name)
  const options = readOptions(args, rows)
  if (options.help) return say(helpText(rows))

  const kept = options.quick ? undefined : path('web/bench/results.csv')
  const file = options.out ? resolve(options.out) : kept
  const { columns } = await import('./bench/records.mjs')
  if (file) checkColumns(file, columns)

  const { chromium } = await setup()
  await build()
  const { runBench } = await import('./bench/run.mjs')
  await runBench(process.env.WARPJET_CHROMIUM ?? chromium, options, file)
})
