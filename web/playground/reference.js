/**
 * For completion and hover: what the docs say of each operation and deformer, read from the pages that are made of the tables, and
 * what our declarations say of inputs, functions and options.
 */
import types from 'virtual:own-types'
import deformersPage from '../docs/deformers.md?raw'
import noisePage from '../docs/noise.md?raw'
import operationsPage from '../docs/operations.md?raw'
import plotsPage from '../docs/plots.md?raw'
import vectorsPage from '../docs/plots-vectors.md?raw'

/** A cell of a table of Markdown as plain text. */
const plain = (cell) => cell.replaceAll(/[`_]|\\(?=\|)/g, '').trim()
const cellsOf = (row) =>
  row
    .slice(1, -1)
    .split(/(?<!\\)\|/)
    .map(plain)

/** By name: { forms, meanings }. A name may stand in more than one row, as `atan` does. */
const operations = new Map()

function add(name, forms, meaning) {
  const known = operations.get(name) ?? { forms: [], meanings: [] }
  operations.set(name, {
    forms: [...known.forms, ...forms.filter((form) => !known.forms.includes(form))],
    meanings: known.meanings.includes(meaning) ? known.meanings : [...known.meanings, meaning],
  })
}

const rowsOf = (page) => page.match(/^\|.*\|$/gm) ?? []

for (const row of rowsOf(operationsPage)) {
  const [first, second, third] = cellsOf(row)
  const isBoth = /^\S*\.\w+\(/.test(second ?? '')
  const meaning = isBoth ? third : second
  const forms = (isBoth ? [first, second] : first.split(/, (?=glsl\.)/)).filter((form) =>
    /^[\w]+\.\w+\(/.test(form),
  )
  for (const [i, form] of forms.entries()) {
    const [, name] = /\.(\w+)\(/.exec(form)
    if (!isBoth || i === 0) add(name, isBoth ? forms : [form], meaning)
  }
}

for (const row of rowsOf(noisePage)) {
  const [form, of, range, smooth] = cellsOf(row)
  const [, name, options] = /^(\w+)\(p, (.*)\)/.exec(form) ?? []
  if (!name) continue
  const forms = [`glsl.${name}(p, ${options})`, `p.${name}(${options})`]
  add(name, forms, `Noise of ${of}: ${range}. Without jumps: ${smooth}.`)
}

/* What each computes. */
for (const row of rowsOf(noisePage)) {
  const [name, formula] = cellsOf(row)
  if (formula.startsWith('Σ')) add(name, [], `Value: ${formula}.`)
}
for (const [, name, formula] of plotsPage.matchAll(/^### (\w+)(?:(?!^###)[^])*?^(Value: .*)$/gm))
  add(name, [], plain(formula))
// Of noise the page above is enough.
const [vectors] = vectorsPage.split('## Kinds of noise')
for (const [, name, formula] of vectors.matchAll(
  /^### (\w+)(?:(?!^###)[^])*?^(`\1\([^]*?)\n\n<!--/gm,
))
  add(name, [], plain(formula.replaceAll('\n\n', ' ')))

/** The first sentence under each heading. */
const deformers = new Map(
  [...deformersPage.matchAll(/^## (\w+)\n\n([^\n]+)/gm)].map(([, name, text]) => [
    name,
    { forms: [`warpjet.${name}({ … })`], meanings: [plain(text)] },
  ]),
)

const known = ({ name, form, meaning, ...more }) => [
  name,
  { forms: [form], meanings: [meaning], ...more },
]

/** What the declarations say that a host has: { inputs, functions }, each by name; functions have `options`, by name, too. */
function ownOf(host) {
  const isThere = (each) => each.host === host || each.host === 'both'
  const functions = types.functions
    .filter(isThere)
    .map(({ options, ...each }) => known({ ...each, options: new Map(options.map(known)) }))
  return { inputs: new Map(types.inputs.filter(isThere).map(known)), functions: new Map(functions) }
}
export const own = { p5: ownOf('p5'), three: ownOf('three') }

/** Those that a page with p5 has as members of `warpjet`. */
export const ofLibrary = new Map(types.functions.filter(({ host }) => host === 'both').map(known))

export { operations, deformers }

/** What a name means to a host, where nothing else tells what it is. */
export const meaningOf = (name, isMember, { inputs, functions }) =>
  (isMember && (operations.get(name) ?? deformers.get(name))) ||
  functions.get(name) ||
  inputs.get(name) ||
  deformers.get(name)
