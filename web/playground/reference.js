/** What the docs say of each operation, deformer and input, for completion and hover: read from the pages that are made of the tables. */
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

/** By name: { forms, meaning, isMethod }. A name may stand in more than one row, as `atan` does. */
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

const inputs = new Map(
  Object.entries({
    glsl: 'The builder: glsl.val(2), glsl.vec3(x, y, z), and every operation.',
    position:
      'The vertex, a vec3 in the space of the warp. A sphere() of p5 goes from -1 to 1 there, whatever its radius; space: "world" makes it pixels.',
    normal: 'The normal of the vertex, a vec3 in the space of the warp.',
    uv: 'The texture coordinates of the vertex, a vec2.',
    color: 'The colour of the vertex or the fill, a vec4.',
    millis: 'Milliseconds since the sketch started, a number.',
    mouse: 'Where the mouse is, in pixels, a vec2.',
    size: 'Width and height of the canvas in pixels, a vec2.',
    pixelDensity: 'Pixels of the screen for one of the canvas.',
    instance: 'Which one of model(shape, count), from 0.',
    uniforms: 'The values of the option uniforms, by name: uniforms.amount.',
  }).map(([name, meaning]) => [name, { forms: [name], meanings: [meaning] }]),
)

const makers = new Map([
  [
    'createWarp',
    {
      forms: [
        'createWarp(({ glsl, position, millis }) => glsl.vec3(x, y, z), { space, uniforms, type })',
      ],
      meanings: [
        'A function that puts the warp on whatever is drawn after it. The offset is how far each vertex moves.',
      ],
    },
  ],
])

export const reference = { operations, deformers, inputs, makers }

/** What a name means, where nothing else tells what it is. */
export const meaningOf = (name, isMember) =>
  (isMember && (operations.get(name) ?? deformers.get(name))) ||
  makers.get(name) ||
  inputs.get(name) ||
  deformers.get(name)
