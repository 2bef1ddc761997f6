// npm run golden: rewrites the shader code in tests/golden, to be reviewed as a diff.
import { rmSync, writeFileSync } from 'node:fs'
import { build } from './build.mjs'
import { good, main } from './lib/terminal.mjs'

await main(async () => {
  await build()
  const { goldenFolder, goldenTexts, readGoldenTexts } = await import('../tests/warps/golden.js')
  const [sources, before] = [goldenTexts(), readGoldenTexts()]
  for (const file of Object.keys(before)) {
    if (!(file in sources)) rmSync(new URL(file, goldenFolder))
  }
  for (const [file, source] of Object.entries(sources))
    writeFileSync(new URL(file, goldenFolder), source)
  const changed = Object.keys({ ...before, ...sources }).filter(
    (file) => sources[file] !== before[file],
  )
  good(changed.length ? `Changed: ${changed.join(', ')}` : 'Nothing has changed.')
})
