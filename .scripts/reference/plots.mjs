// The sections of web/docs/plots.md: each operation on numbers with its formulas, a plot of its value and derivative, and code that
// runs. The site draws the plots (web/site/plot.js) from the values that warpjet computes.
import { Stop } from '../lib/terminal.mjs'
import { formulas } from './formulas.mjs'
import { code, endSentence } from './parts.mjs'

const worksOnNumbers = ({ kinds, result }) =>
  [...kinds, result].every((kind) => kind === 'number or vector')

/** Returns Markdown for the plot of a call, and code of a warp that uses the call. */
export const plotAndCode = (call, from, to) => `<!-- plot ${call} from ${from} to ${to} -->

<!-- prettier-ignore -->
\`\`\`js
createWarp(({ glsl, position }) => {
  const x = position.y().add(1).mult(${(to - from) / 2})${from ? `.add(${from})` : ''}
  const value = ${call}
  return glsl.vec3(value.mult(0.1).clamp(-1, 1), 0, 0)
})
\`\`\`
`

/** Returns two sentences: the value and the derivatives of a row of `formulas`. */
function formulaText({ value, by: derivatives, where = {} }, operands) {
  const parts = Object.entries(where).map(([name, text]) => `, where ${name} is ${code(text)}`)
  const definition = `Value: ${code(value)}${parts.join('')}.`
  if (derivatives.length === 1) return `${definition} Derivative: ${code(derivatives[0])}.`
  const list = derivatives.map((text, i) => `${code(text)} with respect to ${operands[i]}`)
  return `${definition} Derivatives: ${list.join(', ')}.`
}

/** Two operations have the name `atan`. The second one has two operands. */
const titleOf = ({ name, operands }) =>
  name === 'atan' && operands.length > 1 ? 'atan(y, x)' : name

function writeSection(operation) {
  const { name, operands, meaning } = operation
  const title = titleOf(operation)
  const formula = formulas[title]
  const [call, from = -3, to = 3] = formula.plot ?? [`x.${name}()`]
  const text = [endSentence(meaning), formula.remark].filter(Boolean).join(' ')
  return `### ${title}

${text}

${formulaText(formula, operands)}

${plotAndCode(call, from, to)}`
}

/** Throws if an operation has no row in formulas.mjs, or an incomplete row. */
function checkFormulas(operations) {
  const missing = operations.filter((operation) => {
    const { by: derivatives, plot } = formulas[titleOf(operation)] ?? {}
    const count = operation.operands.length
    return derivatives?.length !== count || (count > 1 && !plot)
  })
  if (missing.length)
    throw new Stop(
      `.scripts/reference/formulas.mjs needs a row for ${missing.map(titleOf).join(', ')}: its value, one derivative per operand and, with several operands, a plot.`,
    )
}

export function plotParts({ operations, headings }) {
  const onNumbers = operations.filter(worksOnNumbers)
  checkFormulas(onNumbers)
  const groups = headings
    .map((heading) => {
      const inGroup = onNumbers.filter((operation) => operation.heading === heading)
      return inGroup.length && `## ${heading}\n\n${inGroup.map(writeSection).join('\n')}`
    })
    .filter(Boolean)
  return { plots: groups.join('\n') }
}
