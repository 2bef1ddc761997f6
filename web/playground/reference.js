/**
 * Descriptions for completion and hover: of operations and deformers, read from the generated pages of the docs, and of inputs,
 * functions and options, from our own declarations.
 */
import types from 'virtual:own-types'
import deformersPage from '../docs/deformers.md?raw'
import noisePage from '../docs/noise.md?raw'
import operationsPage from '../docs/operations.md?raw'
import vectorsPage from '../docs/plots-vectors.md?raw'
import plotsPage from '../docs/plots.md?raw'

/** Converts a Markdown table cell to plain text. */
const toPlainText = (cell) => cell.replaceAll(/[`_]|\\(?=\|)/g, '').trim()
const cellsOf = (row) =>
  row
    .slice(1, -1)
    .split(/(?<!\\)\|/)
    .map(toPlainText)

/** Maps name → { forms, meanings }. A name can appear in several rows, as `atan` does. */
const operations = new Map()

function add(name, forms, meaning) {
  const entry = operations.get(name) ?? { forms: [], meanings: [] }
  operations.set(name, {
    forms: [...entry.forms, ...forms.filter((form) => !entry.forms.includes(form))],
    meanings: entry.meanings.includes(meaning) ? entry.meanings : [...entry.meanings, meaning],
  })
}

const rowsOf = (page) => page.match(/^\|.*\|$/gm) ?? []

for (const row of rowsOf(operationsPage)) {
  const [first, second, third] = cellsOf(row)
  const hasMethodForm = /^\S*\.\w+\(/.test(second ?? '')
  const meaning = hasMethodForm ? third : second
  const forms = (hasMethodForm ? [first, second] : first.split(/, (?=glsl\.)/)).filter((form) =>
    /^[\w]+\.\w+\(/.test(form),
  )
  for (const [i, form] of forms.entries()) {
    const [, name] = /\.(\w+)\(/.exec(form)
    if (!hasMethodForm || i === 0) add(name, hasMethodForm ? forms : [form], meaning)
  }
}

for (const row of rowsOf(noisePage)) {
  const [form, points, range, smooth] = cellsOf(row)
  const [, name, options] = /^(\w+)\(p, (.*)\)/.exec(form) ?? []
  if (!name) continue
  const forms = [`glsl.${name}(p, ${options})`, `p.${name}(${options})`]
  add(name, forms, `Noise of ${points}: ${range}. Without jumps: ${smooth}.`)
}

/* The formula of each noise that is a sum, and of each operation. */
for (const row of rowsOf(noisePage)) {
  const [name, formula] = cellsOf(row)
  if (formula.startsWith('Σ')) add(name, [], `Value: ${formula}.`)
}
for (const [, name, formula] of plotsPage.matchAll(/^### (\w+)(?:(?!^###)[^])*?^(Value: .*)$/gm))
  add(name, [], toPlainText(formula))
// Noise is covered by its own page above.
const [vectors] = vectorsPage.split('## Kinds of noise')
for (const [, name, formula] of vectors.matchAll(
  /^### (\w+)(?:(?!^###)[^])*?^(`\1\([^]*?)\n\n<!--/gm,
))
  add(name, [], toPlainText(formula.replaceAll('\n\n', ' ')))

/** Maps each deformer to the first paragraph under its heading. */
const deformers = new Map(
  [...deformersPage.matchAll(/^## (\w+)\n\n([^\n]+)/gm)].map(([, name, text]) => [
    name,
    { forms: [`warpjet.${name}({ … })`], meanings: [toPlainText(text)] },
  ]),
)

const entryOf = ({ name, form, meaning, ...more }) => [
  name,
  { forms: [form], meanings: [meaning], ...more },
]

/** Collects a host's { inputs, functions } from the declarations, each by name; functions also have `options` by name. */
function collectEntries(host) {
  const isOfHost = (each) => each.host === host || each.host === 'both'
  const functions = types.functions
    .filter(isOfHost)
    .map(({ options, ...each }) => entryOf({ ...each, options: new Map(options.map(entryOf)) }))
  return {
    inputs: new Map(types.inputs.filter(isOfHost).map(entryOf)),
    functions: new Map(functions),
  }
}
export const hostEntries = { p5: collectEntries('p5'), three: collectEntries('three') }

/** Functions that are members of the global `warpjet` on pages with p5. */
export const libraryFunctions = new Map(
  types.functions.filter(({ host }) => host === 'both').map(entryOf),
)

export { operations, deformers }

/** Looks up a name for a host. Methods and deformers take precedence for members, the host's functions and inputs otherwise. */
export const meaningOf = (name, isMember, { inputs, functions }) =>
  (isMember && (operations.get(name) ?? deformers.get(name))) ||
  functions.get(name) ||
  inputs.get(name) ||
  deformers.get(name)
