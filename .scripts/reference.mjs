// npm run reference: writes types and tables from the C++ tables of operations, the generated parts of the docs, and the page of
// each example.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { path } from './lib/files.mjs'
import { good, isMain, main } from './lib/terminal.mjs'
import { deformerParts } from './reference/deformers.mjs'
import { meshTablesText, tablesText } from './reference/enumerations.mjs'
import { examplePages } from './reference/example-pages.mjs'
import { identityParts } from './reference/identities.mjs'
import { operationParts } from './reference/operations.mjs'
import { formatAs, replaceParts } from './reference/parts.mjs'
import { vectorPlotParts } from './reference/plots-vectors.mjs'
import { plotParts } from './reference/plots.mjs'
import { readTable } from './reference/table.mjs'
import { typesText } from './reference/types.mjs'
import { setup } from './setup.mjs'

const read = (file) => (existsSync(path(file)) ? readFileSync(path(file), 'utf8') : null)

/** Lists the generated files that are out of date: [{ file, text }], where `text` is the new content. */
export async function staleFiles() {
  const [table, deformers] = await Promise.all([readTable(), deformerParts()])
  const files = {
    'js-bindings/core/types/methods.ts': typesText(table),
    'js-bindings/wasm/tables.ts': tablesText(table),
    'js-bindings/wasm/mesh-tables.ts': meshTablesText(table),
    ...examplePages(),
  }
  const pages = {
    operations: operationParts(table, read('web/docs/operations.md')),
    plots: plotParts(table),
    'plots-vectors': vectorPlotParts(table),
    identities: identityParts(table),
    deformers,
  }
  const contents = [
    ...Object.entries(files).map(async ([file, text]) => ({
      file,
      text: await formatAs(file, text),
    })),
    ...Object.entries(pages).map(async ([name, parts]) => {
      const file = `web/docs/${name}.md`
      return { file, text: await replaceParts(file, parts) }
    }),
  ]
  return (await Promise.all(contents)).filter(({ file, text }) => read(file) !== text)
}

if (isMain(import.meta))
  await main(async () => {
    await setup()
    const stale = await staleFiles()
    for (const { file, text } of stale) {
      mkdirSync(dirname(path(file)), { recursive: true })
      writeFileSync(path(file), text)
    }
    const names = stale.map(({ file }) => file).join(', ')
    good(names ? `Changed: ${names}` : 'Nothing has changed.')
  })
