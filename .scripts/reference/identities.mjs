// Writes the tables of web/docs/identities.md. Each row is an identity of src/graph/identities.hpp or,
// in the table `turns`, of src/graph/rotations.hpp.
import { Stop } from '../lib/terminal.mjs'
import { code, markdownTable } from './parts.mjs'

/** Maps the heading of each table → the operations whose identities it has. */
const headings = {
  'Minus and not': ['neg', 'not'],
  Sums: ['add'],
  Differences: ['sub'],
  Products: ['mult'],
  Quotients: ['div'],
  Powers: ['pow'],
  Choices: ['ifElse'],
  'Choices of whole numbers': ['intIfElse'],
  'Bounds and blends': ['clamp', 'mix'],
}

const precisions = {
  bits: 'all bits',
  value: 'all but the sign of a zero',
  rounding: 'all but rounding',
}

export function identityParts({ identities, turns }) {
  const groups = Object.entries(headings).map(([heading, operations]) => {
    const rows = identities.filter(({ operation }) => operations.includes(operation))
    return `## ${heading}\n\n${writeTable(rows)}`
  })
  const listedOperations = Object.values(headings).flat()
  const missing = identities.filter(({ operation }) => !listedOperations.includes(operation))
  if (missing.length)
    throw new Stop(`.scripts/reference/identities.mjs needs a heading for ${missing[0].operation}.`)
  return { identities: groups.join('\n\n'), turns: writeTable(turns) }
}

const writeTable = (rows) =>
  markdownTable(
    ['this', 'becomes', 'if', 'which keeps'],
    rows.map(({ from, to, when, ...keeps }) => [
      code(from),
      code(to),
      when && code(when),
      describePrecision(keeps),
    ]),
  )

const describePrecision = ({ precision, onlyNumbers }) =>
  precisions[precision] + (onlyNumbers ? ', where it is a number' : '')
