// Reads the tables of operations from the C++. `npm run reference` generates types and docs from them.
import { readFileSync } from 'node:fs'
import { cmakeBuild } from '../lib/cmake.mjs'
import { path } from '../lib/files.mjs'
import { capture } from '../lib/run.mjs'
import { Stop } from '../lib/terminal.mjs'

/** Maps the letters of `Kind` in src/builder/compositions.hpp → the names of kinds in the docs. */
const kinds = {
  s: 'number',
  v: 'vector',
  3: 'vec3',
  x: 'number or vector',
  m: 'square matrix',
  M: 'matrix',
  e: 'any',
  9: 'mat3',
  i: 'input',
  I: 'vector of inputs',
  J: 'vec3 of inputs',
}

function kindOf(letter) {
  if (!(letter in kinds)) throw new Stop(`.scripts/reference/table.mjs lacks the kind ${letter}.`)
  return kinds[letter]
}

const namesIn = (files, pattern) =>
  files.flatMap((file) =>
    [...readFileSync(path(file), 'utf8').matchAll(pattern)].map(([, name]) => name),
  )

/** Throws if an operation lacks a row. The C++ compiler would reject that, too, but without the name of the operation. */
function checkRows() {
  const declared = namesIn(['src/ops/declarations.hpp'], /^ {4}\w+\("(\w+)"/gm)
  for (const [files, pattern] of [
    [['src/ops/table.hpp', 'src/ops/int_rows.hpp'], /\brow\(\s*"(\w+)"/g],
    [['src/ops/documentation.hpp'], /\bTitle\{"(\w+)"/g],
  ]) {
    const present = namesIn(files, pattern)
    const missing = declared.filter((name) => !present.includes(name))
    if (missing.length) throw new Stop(`${files[0]} lacks a row for ${missing.join(', ')}.`)
  }
}

export async function readTable() {
  checkRows()
  await cmakeBuild('native', 'warpjet_table')
  const text = await capture(path('.build/native/warpjet_table'), [])
  if (text === null) throw new Stop('.build/native/warpjet_table does not run.')
  return arrangeTables(JSON.parse(text))
}

/**
 * Returns { operations, aliases, others, headings }, and the fields that enumerations.mjs reads. An operation is { name, operands, kinds,
 * result, meaning, isChained, takesMatrices, missingIn, heading }. `others` are the names of functions that compose vectors and matrices
 * or take them apart.
 */
function arrangeTables({ rows, compositions, headings, ...otherTables }) {
  // Maps the first operation under a heading → the heading.
  const unusedHeadings = new Map(headings.map(({ text, first }) => [first, text]))
  let heading
  const operations = [...rows, ...compositions]
    .filter(({ isListed }) => isListed)
    .map((operation) => {
      heading = unusedHeadings.get(operation.name) ?? heading
      unusedHeadings.delete(operation.name)
      return {
        ...operation,
        heading,
        operands: operation.operands.split(', '),
        kinds: [...operation.kinds].map(kindOf),
        result: kindOf(operation.result),
      }
    })
  if (unusedHeadings.size || !operations[0].heading)
    throw new Stop(
      'Expected each heading in src/builder/operations.hpp to name the first operation under it, and a heading for the first operation.',
    )
  return { ...otherTables, operations, headings: [...new Set(headings.map(({ text }) => text))] }
}
