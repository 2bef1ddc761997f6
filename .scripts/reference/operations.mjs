// Writes the tables of web/docs/operations.md, one per group of operations.
import { Stop } from '../lib/terminal.mjs'
import { code, markdownTable } from './parts.mjs'

/** Returns the generated parts of the page. `page` is the text of the page, which must mention the operations in `others`. */
export function operationParts({ operations, aliases, others, headings }, page) {
  const missing = others.filter((name) => !page.includes(`${name}(`))
  if (missing.length) throw new Stop(`web/docs/operations.md lacks ${missing.join(', ')}.`)
  const groups = headings.map((heading) =>
    writeGroup(
      heading,
      operations.filter((operation) => operation.heading === heading),
    ),
  )
  return {
    operations: groups.join('\n'),
    aliases: `From glsl-autodiff: ${describeAliases(aliases)}.`,
  }
}

function writeGroup(heading, operations) {
  const isByComponent = ({ kinds }) => kinds.every((kind) => kind === 'number or vector')
  const columns = [
    ['function', (operation) => code(functionForm(operation))],
    ['method', (operation) => code(methodForm(operation))],
    ['what it is', ({ meaning }) => meaning],
  ]
  if (!operations.every(isByComponent)) columns.push(['operands → result', writeTypes])
  if (operations.some(({ missingIn }) => missingIn.length))
    columns.push(['lowered in', ({ missingIn }) => listLanguages(missingIn)])
  const table = markdownTable(
    columns.map(([head]) => head),
    operations.map((operation) => columns.map(([, cell]) => cell(operation))),
  )
  return `## ${heading}\n\n${table}\n${notes[heading] ?? ''}`
}

const furtherOperands = ({ isChained }) => (isChained ? ', …' : '')

function functionForm(operation) {
  return `glsl.${operation.name}(${operation.operands.join(', ')}${furtherOperands(operation)})`
}

function methodForm(operation) {
  const [receiver, ...others] = operation.operands
  return `${receiver}.${operation.name}(${others.join(', ')}${furtherOperands(operation)})`
}

function writeTypes({ kinds, result }) {
  return `${kinds.join(', ')} → ${result}`
}

/** There are three shading languages. */
const listLanguages = (names) => (names.length === 3 ? 'all' : names.map(code).join(', '))

/** Maps a heading → the note below its table. */
const notes = {
  Conditions: `
A condition is 1 or 0 where it is used as a number.
`,
  Matrices: `
Matrices also have \`neg\`, \`add\`, \`sub\`, \`mix\`, \`mult\`, and \`div\` by a number. \`m.mult(v)\` is a matrix times a column,
\`v.mult(m)\` a row times a matrix.
`,
  Derivatives: `
An input is a variable of the shader, such as \`millis\`, \`position.x()\` or \`glsl.param('speed')\`, not a computed value.
Derivatives can be differentiated again: \`height.derivative(millis).derivative(millis)\` is an acceleration.
`,
}

/** Returns "`a` and `b` are `c`, `d` is `e`, …", where `c` and `e` are the originals of the aliases. */
function describeAliases(aliases) {
  const originals = [...new Set(aliases.map(({ original }) => original))]
  const texts = originals.map((original) => {
    const names = aliases
      .filter((alias) => alias.original === original)
      .map(({ name }) => code(name))
    return `${names.join(' and ')} ${names.length > 1 ? 'are' : 'is'} ${code(original)}`
  })
  return texts.join(', ')
}
