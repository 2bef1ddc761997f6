// The sections of web/docs/plots-vectors.md: operations on vectors and matrices, derivatives, and noise, with formulas, plots and code.
import { Stop } from '../lib/terminal.mjs'
import { noiseFormulas } from './noise-formulas.mjs'
import { code, endSentence } from './parts.mjs'
import { plotAndCode } from './plots.mjs'
import { vectorFormulas } from './vector-formulas.mjs'

/** Maps each product of matrices and vectors → its meaning. The C++ table of operations has `mult` only for numbers. */
const products = {
  'mult(A, B)': 'The product of two matrices.',
  'mult(A, v)': 'A matrix times a column.',
  'mult(v, A)': 'A row times a matrix.',
}

/**
 * Maps each operation that returns a derivative → { text, plot, body }. `text` describes the operation and its own derivative, if it has no
 * row in vector-formulas.mjs; `plot` is the expression that is plotted, and the range of x; `body` is that of the example's function.
 */
const derivatives = {
  derivative: {
    text: '`derivative(f, t)` is `∂f/∂t`. Its own derivative is the second derivative, `∂²f/∂t²`.',
    plot: ['x.sin().derivative(x)', -3, 3],
    body: `const height = position.y().mult(3).sin()
return glsl.vec3(height.derivative(position.y()).mult(0.1), 0, 0)`,
  },
  gradient: {
    text: '`gradient(f, p)` is `(∂f/∂p₁, ∂f/∂p₂, …)`. Its own derivative is `H dp`, where H has `∂²f/∂pᵢ∂pⱼ` in row i and column j.',
    body: `const height = position.mult(2).sin().dot(position)
return height.gradient(position).mult(0.1)`,
  },
  jacobian: {
    text: '`jacobian(f, p)` has `∂fᵢ/∂pⱼ` in row i and column j. Its own derivative consists of the second derivatives of f.',
    body: `const turned = glsl.rotateY(position.y()).mult(position)
return turned.jacobian(position).column(1).mult(0.3)`,
  },
  adjustNormal: {
    body: `const bump = glsl.vec3(0, position.x().mult(4).sin().mult(0.2), 0)
return bump.adjustNormal(normal, position).mult(0.3)`,
  },
  adjustTangent: {
    body: `const bump = glsl.vec3(0, position.x().mult(4).sin().mult(0.2), 0)
const facing = bump.adjustNormal(normal, position)
return bump.adjustTangent(glsl.vec3(1, 0, 0), facing, position).mult(0.3)`,
  },
}

/** Returns the formula of an operation and that of its derivative, in sentences. */
function formulaText({ form, value, derivative, where = {} }) {
  const isUsed = (name) => RegExp(`(?<![A-Za-z])${name}(?![A-Za-z])`, 'u').test(derivative)
  const parts = Object.entries(where).map(([name, text]) => code(`${name} = ${text}`))
  if (isUsed('w') && !where.w) parts.push('w is the value')
  // Several definitions become a paragraph of their own, because on a phone each takes several lines.
  const between = parts.length > 1 ? '\n\n' : ' '
  const definitions = parts.length ? `,${between}where ${parts.join(', ')}` : ''
  return `${code(form)} is ${code(value)}.${between}Derivative: ${code(derivative)}${definitions}.`
}

function vectorSection(title, meaning) {
  const formula = vectorFormulas[title]
  const { remark, call, from = -3, to = 3 } = formula
  const text = [endSentence(meaning), remark].filter(Boolean).join(' ')
  return `### ${title}\n\n${text}\n\n${formulaText(formula)}\n\n${plotAndCode(call, from, to)}`
}

function derivativeSection({ name, meaning }) {
  const { plot, body } = derivatives[name]
  const formula = vectorFormulas[name]
  const text = formula ? `${formulaText(formula)} ${formula.remark}` : derivatives[name].text
  const plotComment = plot ? `<!-- plot ${plot[0]} from ${plot[1]} to ${plot[2]} -->\n\n` : ''
  return `### ${name}

${endSentence(meaning)}

${text}

${plotComment}<!-- prettier-ignore -->
\`\`\`js
createWarp(({ glsl, position${body.includes('normal,') ? ', normal' : ''} }) => {
${body.replaceAll(/^/gm, '  ')}
}${body.includes('normal,') ? ', { surfaceVariation: true }' : ''})
\`\`\`
`
}

function noiseSection(name) {
  const { value, derivative, symbols, remark, call, from = 0, to = 6 } = noiseFormulas[name]
  const text = `${code(`${name}(p)`)} is ${code(value)}. Derivative: ${code(derivative)}. ${symbols}.`
  return `### ${name}\n\n${[text, remark].filter(Boolean).join(' ')}\n\n${plotAndCode(call, from, to)}`
}

/** Throws if a name has no row in `table`, which is in `file`. */
function checkRows(file, table, names) {
  const missing = names.filter((name) => !(name in table))
  if (missing.length)
    throw new Stop(`.scripts/reference/${file} needs a row for ${missing.join(', ')}.`)
}

export function vectorPlotParts({ operations, noises }) {
  const operationsOf = (heading) => operations.filter((operation) => operation.heading === heading)
  const namesOf = (list) => list.map(({ name }) => name)
  const onVectors = [...operationsOf('Vectors'), ...operationsOf('Matrices')]
  checkRows('vector-formulas.mjs', vectorFormulas, namesOf(onVectors))
  checkRows('plots-vectors.mjs', derivatives, namesOf(operationsOf('Derivatives')))
  checkRows('noise-formulas.mjs', noiseFormulas, namesOf(noises))
  const sections = (heading) =>
    operationsOf(heading).map(({ name, meaning }) => vectorSection(name, meaning))
  const productSections = Object.entries(products).map(([title, meaning]) =>
    vectorSection(title, meaning),
  )
  return {
    vectors: sections('Vectors').join('\n'),
    matrices: [...sections('Matrices'), ...productSections].join('\n'),
    derivatives: operationsOf('Derivatives').map(derivativeSection).join('\n'),
    noise: noises.map(({ name }) => noiseSection(name)).join('\n'),
  }
}
