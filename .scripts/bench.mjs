// npm run bench: measures a frame with each method of drawing a warped mesh, in headless Chromium; --help lists the options.
// npm run bench -- evaluate | generate | …: runs another benchmark, .scripts/bench/evaluate.mjs and so on.
import { readdirSync } from 'node:fs'
import { helpText, readOptions } from './bench/frames/options.mjs'
import { checkColumns } from './bench/frames/records.mjs'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const args = process.argv.slice(2)
  const otherBenchmark = readdirSync(path('.scripts/bench')).find(
    (file) => file === `${args[0]}.mjs`,
  )
  const options = otherBenchmark ? {} : readOptions(args)
  if (options.help) return say(helpText)
  if (options.file) checkColumns(options.file)
  process.env.WARPJET_CHROMIUM = (await setup()).chromium
  await build()
  const { measure } = await import(`./bench/${otherBenchmark ?? 'frames/run.mjs'}`)
  await measure(otherBenchmark ? args.slice(1) : options)
}, '--help lists the options.')
