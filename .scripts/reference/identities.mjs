// web/docs/identities.md: what warpjet simplifies, a row of src/graph/identities.hpp a row.
import { Stop } from '../lib/terminal.mjs'

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

/** The text of the page, not yet formatted. */
export function identitiesText({ identities, turns }) {
  const groups = Object.entries(headings).map(([heading, operations]) => {
    const rows = identities.filter(({ operation }) => operations.includes(operation))
    return `## ${heading}\n\n${table(rows)}`
  })
  const listed = Object.values(headings).flat()
  const missing = identities.filter(({ operation }) => !listed.includes(operation))
  if (missing.length)
    throw new Stop(`.scripts/reference/identities.mjs needs a heading for ${missing[0].operation}.`)
  return page(groups, turns)
}

const table = (rows) =>
  [
    '| this | becomes | if | which keeps |',
    '| --- | --- | --- | --- |',
    ...rows.map(
      ({ from, to, when, ...keeps }) =>
        `| ${code(from)} | ${code(to)} | ${when && code(when)} | ${kept(keeps)} |`,
    ),
  ].join('\n')

const code = (text) => `\`${text.replaceAll('|', '\\|')}\``

const kept = ({ precision, onlyNumbers }) =>
  precisions[precision] + (onlyNumbers ? ', where it is a number' : '')

const page = (
  groups,
  turns,
) => `<!-- Written by \`npm run reference\` from src/graph/identities.hpp. -->

# Identities

While an offset is recorded, and while its derivatives are taken, every operation is simplified as it is made: by the first row
here that fits. Most of what is left of a Jacobian is zeros and ones, and so most of it goes.

In the rows \`x\`, \`y\`, \`z\`, \`t\`, \`u\` and the condition \`c\` stand for anything, \`v\` for anything but a constant, and \`a\`, \`b\` and
\`n\` for constants; what is computed from constants alone becomes a constant. Sums and products match in either order. An operation
on constants alone is computed at once. A number \`isNormal\` if single precision has it with all digits, an exponent is a whole number
from 1 to 16, and \`powerOfTwo(n)\` is the greatest power of two up to \`n\`.

The last column says what the replacement keeps of the value. _All bits_ includes infinities and what is not a number. _All but
rounding_ means a few roundings of the largest intermediate result, unless one overflows or underflows. _Where it is a number_: an
infinite \`x\` makes \`x * 0\` no number, but here it is 0; otherwise every zero of a Jacobian would stay in the shader. A test holds each row
to what it says, at zeros, infinities, denormal and random numbers, in double and single precision.

${groups.join('\n\n')}

## Turns

These match in any order and with any signs, and the factors \`x\`, \`y\` and \`k\` may be missing: \`sin(u) * sin(u) + cos(u) * cos(u)\` is 1.
The normal of a [twist](composition.md) gets rid of its angle in this way. Sines and cosines of a GPU are not exact, and so what is
folded and what is not then differ by the factor \`sin² + cos²\`.

${table(turns)}
`
