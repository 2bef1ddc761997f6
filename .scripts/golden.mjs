// npm run golden: rewrites the shader code in tests/golden, to be reviewed as a diff.
import { rmSync, writeFileSync } from 'node:fs'
import { build } from './build.mjs'
import { good, main } from './lib/terminal.mjs'

await main(async () => {
  await build()
  const { goldenFolder, goldenTexts, readGoldenTexts } = await import('../tests/warps/golden.js')
  const [texts, before] = [goldenTexts(), readGoldenTexts()]
  for (const file of Object.keys(before)) {
    if (!(file in texts)) rmSync(new URL(file, goldenFolder))
  }
  for (const [file, text] of Object.entries(texts)) writeFileSync(new URL(file, goldenFolder), text)
  const changed = Object.keys({ ...before, ...texts }).filter(
    (file) => texts[file] !== before[file],
  )
  good(changed.length ? `Changed: ${changed.join(', ')}` : 'Nothing has changed.')
})
