// npm run sizes: builds, and records the size of each file, so that the diff of a commit shows which files it makes larger.
import { build } from './build.mjs'
import { recordSizes } from './lib/sizes.mjs'
import { main } from './lib/terminal.mjs'

await main(async () => {
  await build()
  recordSizes()
})
