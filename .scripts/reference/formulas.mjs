// What each plotted operation computes, and its derivatives by its operands, as one would write them; `web/docs/plots.md` shows them.
// tests/core/formulas.test.js holds each against what warpjet computes. Where several operands share a part, `where` names it.

/** By name: { value, by: [a derivative for each operand], where }. */
export const formulas = {
  neg: { value: '-x', by: ['-1'] },
  add: { value: 'x + y', by: ['1', '1'] },
  sub: { value: 'x - y', by: ['1', '-1'] },
  mult: { value: 'x * y', by: ['y', 'x'] },
  div: { value: 'x / y', by: ['1 / y', '-x / (y * y)'] },
  pow: {
    value: 'pow(x, exponent)',
    by: ['exponent * pow(x, exponent - 1)', 'pow(x, exponent) * log(x)'],
  },
  sqrt: { value: 'sqrt(x)', by: ['1 / (2 * sqrt(x))'] },
  inversesqrt: { value: '1 / sqrt(x)', by: ['-1 / (2 * x * sqrt(x))'] },
  exp: { value: 'exp(x)', by: ['exp(x)'] },
  exp2: { value: 'pow(2, x)', by: ['log(2) * pow(2, x)'] },
  log: { value: 'log(x)', by: ['1 / x'] },
  log2: { value: 'log(x) / log(2)', by: ['1 / (x * log(2))'] },
  sin: { value: 'sin(x)', by: ['cos(x)'] },
  cos: { value: 'cos(x)', by: ['-sin(x)'] },
  tan: { value: 'sin(x) / cos(x)', by: ['1 + tan(x) * tan(x)'] },
  asin: { value: 'asin(x)', by: ['1 / sqrt(1 - x * x)'] },
  acos: { value: 'PI / 2 - asin(x)', by: ['-1 / sqrt(1 - x * x)'] },
  atan: { value: 'atan(x)', by: ['1 / (1 + x * x)'] },
  'atan(y, x)': { value: 'atan2(y, x)', by: ['x / (x * x + y * y)', '-y / (x * x + y * y)'] },
  radians: { value: 'degrees * PI / 180', by: ['PI / 180'] },
  degrees: { value: 'radians * 180 / PI', by: ['180 / PI'] },
  sinh: { value: '(exp(x) - exp(-x)) / 2', by: ['cosh(x)'] },
  cosh: { value: '(exp(x) + exp(-x)) / 2', by: ['sinh(x)'] },
  tanh: { value: 'sinh(x) / cosh(x)', by: ['1 / (cosh(x) * cosh(x))'] },
  asinh: { value: 'log(x + sqrt(x * x + 1))', by: ['1 / sqrt(x * x + 1)'] },
  acosh: { value: 'log(x + sqrt(x * x - 1))', by: ['1 / sqrt(x * x - 1)'] },
  atanh: { value: 'log((1 + x) / (1 - x)) / 2', by: ['1 / (1 - x * x)'] },
  abs: { value: 'x < 0 ? -x : x', by: ['sign(x)'] },
  sign: { value: 'x < 0 ? -1 : x > 0 ? 1 : 0', by: ['0'] },
  floor: { value: 'floor(x)', by: ['0'] },
  ceil: { value: '-floor(-x)', by: ['0'] },
  round: { value: 'floor(x + 0.5)', by: ['0'] },
  trunc: { value: 'x < 0 ? ceil(x) : floor(x)', by: ['0'] },
  fract: { value: 'x - floor(x)', by: ['1'] },
  mod: { value: 'x - divisor * floor(x / divisor)', by: ['1', '-floor(x / divisor)'] },
  min: { value: 'x <= y ? x : y', by: ['x <= y ? 1 : 0', 'x <= y ? 0 : 1'] },
  max: { value: 'x >= y ? x : y', by: ['x >= y ? 1 : 0', 'x >= y ? 0 : 1'] },
  clamp: {
    value: 'min(max(x, low), high)',
    by: [
      'low <= x && x <= high ? 1 : 0',
      'x < low && low <= high ? 1 : 0',
      'max(x, low) > high ? 1 : 0',
    ],
  },
  mix: { value: 'x + (y - x) * amount', by: ['1 - amount', 'amount', 'y - x'] },
  step: { value: 'x < edge ? 0 : 1', by: ['0', '0'] },
  smoothstep: {
    value: 't * t * (3 - 2 * t)',
    by: [
      '6 * t * (1 - t) * (t - 1) / (high - low)',
      '-6 * t * (1 - t) * t / (high - low)',
      '6 * t * (1 - t) / (high - low)',
    ],
    where: { t: 'clamp((x - low) / (high - low), 0, 1)' },
  },
  lt: { value: 'x < y ? 1 : 0', by: ['0', '0'] },
  le: { value: 'x <= y ? 1 : 0', by: ['0', '0'] },
  gt: { value: 'x > y ? 1 : 0', by: ['0', '0'] },
  ge: { value: 'x >= y ? 1 : 0', by: ['0', '0'] },
  eq: { value: 'x == y ? 1 : 0', by: ['0', '0'] },
  ne: { value: 'x != y ? 1 : 0', by: ['0', '0'] },
  and: { value: 'x != 0 && y != 0 ? 1 : 0', by: ['0', '0'] },
  or: { value: 'x != 0 || y != 0 ? 1 : 0', by: ['0', '0'] },
  not: { value: 'x != 0 ? 0 : 1', by: ['0'] },
  ifElse: {
    value: 'condition != 0 ? yes : no',
    by: ['0', 'condition != 0 ? 1 : 0', 'condition != 0 ? 0 : 1'],
  },
}

const code = (text) => `\`${text}\``

/** The lines of an operation's section that say so. `operands` are its own, in order. */
export function formulaText(title, operands) {
  const formula = formulas[title]
  if (formula?.by.length !== operands.length)
    throw new Error(`.scripts/reference/formulas.mjs lacks what ${title} computes.`)
  const { value, by, where = {} } = formula
  const named = Object.entries(where).map(([name, text]) => `, where ${name} is ${code(text)}`)
  const derivatives = by.map((text, i) =>
    by.length > 1 ? `by ${operands[i]} ${code(text)}` : code(text),
  )
  return `Value: ${code(value)}${named.join('')}. Derivative: ${derivatives.join(', ')}.`
}
