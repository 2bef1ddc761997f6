// npm run sizes: builds, and records what each file weighs, so that a commit that makes one grow shows it.
import { build } from './build.mjs'
import { walk } from './lib/files.mjs'
import { recordSizes } from './lib/sizes.mjs'
import { main } from './lib/terminal.mjs'

await main(async () => {
  await build()
  recordSizes(walk('dist', /\.js$/))
})
