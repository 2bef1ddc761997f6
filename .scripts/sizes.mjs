// npm run sizes: builds, and records the size of each file, so that a commit shows which files it makes grow.
import { build } from './build.mjs'
import { recordSizes } from './lib/sizes.mjs'
import { main } from './lib/terminal.mjs'

await main(async () => {
  await build()
  recordSizes()
})
