// npm run bench: what a frame costs by every way to draw a warped mesh, in headless Chromium. --help tells the rest.
import { resolve } from 'node:path'
import { checkColumns } from './bench/csv.mjs'
import { helpText, readOptions } from './bench/options.mjs'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const { workloads } = await import('../web/bench/workloads.js')
  const rows = workloads.map(({ name }) => name)
  const options = readOptions(process.argv.slice(2), rows)
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
