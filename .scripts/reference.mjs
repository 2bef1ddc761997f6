// npm run reference: writes what the tables of operations say as TypeScript types and as pages of the docs, what the sources of
// the deformers say as another, the pictures of the page of units, and the page of each example.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { path } from './lib/files.mjs'
import { good, isMain, main } from './lib/terminal.mjs'
import { deformersText } from './reference/deformers.mjs'
import { examplePages } from './reference/example-pages.mjs'
import { identitiesText } from './reference/identities.mjs'
import { meshNumberedText, numberedText } from './reference/numbered.mjs'
import { pageText } from './reference/page.mjs'
import { plotsText } from './reference/plots.mjs'
import { plotsVectorsText } from './reference/plots-vectors.mjs'
import { readTable } from './reference/table.mjs'
import { typesText } from './reference/types.mjs'
import { shapesPicture, spacesPicture } from './reference/units-pictures.mjs'
import { setup } from './setup.mjs'

/** The files that are not as the tables would have them, with the text that they should have. */
export async function staleFiles() {
  const { format, resolveConfig } = await import('prettier')
  const table = await readTable()
  const texts = {
    'js-bindings/core/types/methods.ts': typesText(table),
    'js-bindings/wasm/tables.ts': numberedText(table),
    'js-bindings/wasm/mesh-tables.ts': meshNumberedText(table),
    'web/docs/operations.md': pageText(table),
    'web/docs/plots.md': plotsText(table),
    'web/docs/plots-vectors.md': plotsVectorsText(table),
    'web/docs/identities.md': identitiesText(table),
    'web/docs/deformers.md': deformersText(),
    'web/docs/units-spaces.svg': spacesPicture(),
    'web/docs/units-1.svg': shapesPicture(0),
    'web/docs/units-2.svg': shapesPicture(1),
    ...examplePages(),
  }
  const stale = []
  for (const [file, text] of Object.entries(texts)) {
    const options = { ...(await resolveConfig(path(file))), filepath: path(file) }
    const formatted = file.endsWith('.svg') ? text : await format(text, options)
    const kept = existsSync(path(file)) && readFileSync(path(file), 'utf8')
    if (kept !== formatted) stale.push({ file, text: formatted })
  }
  return stale
}

if (isMain(import.meta))
  await main(async () => {
    await setup()
    const stale = await staleFiles()
    for (const { file, text } of stale) {
      mkdirSync(dirname(path(file)), { recursive: true })
      writeFileSync(path(file), text)
    }
    good(
      stale.length
        ? `Changed: ${stale.map(({ file }) => file).join(', ')}`
        : 'Nothing has changed.',
    )
  })
