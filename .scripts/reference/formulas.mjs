// The formulas of operations on numbers, for web/docs/plots.md. tests/core/formulas.test.js compares each with what warpjet computes.

const jumpRemark = 'The derivative is 0 everywhere, at the steps too.'
const conditionRemark =
  'As a number it is 1 or 0, and its derivative 0 everywhere, at the step too.'
const operandRemark =
  'The derivative is that of the operand whose value is taken: of the first one if they are equal.'
const infiniteAtZero = 'At 0, value and derivative are infinite.'

/**
 * Maps each operation → its row:
 * - `value` and `by`: JavaScript expressions of the value and of its derivatives with respect to each operand. `where` defines terms that
 *   several of these expressions share.
 * - `plot`: the call that is plotted, and the range of x. Default call, for operations of one operand: `x.name()`. Default range: -3 to 3.
 * - `remark`: what warpjet returns as derivative where the function is not differentiable.
 */
export const formulas = {
  neg: { value: '-x', by: ['-1'] },
  add: { value: 'x + y', by: ['1', '1'], plot: ['x.add(1)'] },
  sub: { value: 'x - y', by: ['1', '-1'], plot: ['x.sub(1)'] },
  mult: { value: 'x * y', by: ['y', 'x'], plot: ['x.mult(2)'] },
  div: {
    value: 'x / y',
    by: ['1 / y', '-x / (y * y)'],
    plot: ['glsl.div(1, x)'],
    remark: infiniteAtZero,
  },
  pow: {
    value: 'pow(x, exponent)',
    by: ['exponent * pow(x, exponent - 1)', 'pow(x, exponent) * log(x)'],
    plot: ['x.pow(3)', -1.5, 1.5],
  },
  sqrt: { value: 'sqrt(x)', by: ['1 / (2 * sqrt(x))'], plot: ['x.sqrt()', 0, 4] },
  inversesqrt: {
    value: '1 / sqrt(x)',
    by: ['-1 / (2 * x * sqrt(x))'],
    plot: ['x.inversesqrt()', 0.05, 4],
    remark: infiniteAtZero,
  },
  exp: { value: 'exp(x)', by: ['exp(x)'], plot: ['x.exp()', -3, 1.5] },
  exp2: { value: 'pow(2, x)', by: ['log(2) * pow(2, x)'], plot: ['x.exp2()', -3, 2] },
  log: { value: 'log(x)', by: ['1 / x'], plot: ['x.log()', 0.05, 4], remark: infiniteAtZero },
  log2: {
    value: 'log(x) / log(2)',
    by: ['1 / (x * log(2))'],
    plot: ['x.log2()', 0.05, 4],
    remark: infiniteAtZero,
  },
  sin: { value: 'sin(x)', by: ['cos(x)'] },
  cos: { value: 'cos(x)', by: ['-sin(x)'] },
  tan: { value: 'sin(x) / cos(x)', by: ['1 + tan(x) * tan(x)'], plot: ['x.tan()', -4, 4] },
  asin: {
    value: 'asin(x)',
    by: ['1 / sqrt(1 - x * x)'],
    plot: ['x.asin()', -1, 1],
    remark: 'At -1 and 1 the derivative counts as 0.',
  },
  acos: {
    value: 'PI / 2 - asin(x)',
    by: ['-1 / sqrt(1 - x * x)'],
    plot: ['x.acos()', -1, 1],
    remark: 'At -1 and 1 the derivative counts as 0.',
  },
  atan: { value: 'atan(x)', by: ['1 / (1 + x * x)'] },
  'atan(y, x)': {
    value: 'atan2(y, x)',
    by: ['x / (x * x + y * y)', '-y / (x * x + y * y)'],
    plot: ['glsl.atan(x, -1)', -4, 4],
  },
  radians: { value: 'degrees * PI / 180', by: ['PI / 180'], plot: ['x.radians()', -180, 180] },
  degrees: { value: 'radians * 180 / PI', by: ['180 / PI'] },
  sinh: { value: '(exp(x) - exp(-x)) / 2', by: ['cosh(x)'], plot: ['x.sinh()', -2, 2] },
  cosh: { value: '(exp(x) + exp(-x)) / 2', by: ['sinh(x)'], plot: ['x.cosh()', -2, 2] },
  tanh: { value: 'sinh(x) / cosh(x)', by: ['1 / (cosh(x) * cosh(x))'] },
  asinh: { value: 'log(x + sqrt(x * x + 1))', by: ['1 / sqrt(x * x + 1)'] },
  acosh: {
    value: 'log(x + sqrt(x * x - 1))',
    by: ['1 / sqrt(x * x - 1)'],
    plot: ['x.acosh()', 1, 5],
    remark: 'At 1 the derivative counts as 0.',
  },
  atanh: {
    value: 'log((1 + x) / (1 - x)) / 2',
    by: ['1 / (1 - x * x)'],
    plot: ['x.atanh()', -1, 1],
    remark: 'At -1 and 1, value and derivative are infinite.',
  },
  abs: { value: 'x < 0 ? -x : x', by: ['sign(x)'], remark: 'At 0 the derivative is 0.' },
  sign: {
    value: 'x < 0 ? -1 : x > 0 ? 1 : 0',
    by: ['0'],
    remark: 'The derivative is 0 everywhere, at the step too.',
  },
  floor: { value: 'floor(x)', by: ['0'], remark: jumpRemark },
  ceil: { value: '-floor(-x)', by: ['0'], remark: jumpRemark },
  round: { value: 'floor(x + 0.5)', by: ['0'], remark: jumpRemark },
  trunc: { value: 'x < 0 ? ceil(x) : floor(x)', by: ['0'], remark: jumpRemark },
  fract: {
    value: 'x - floor(x)',
    by: ['1'],
    remark: 'The derivative is 1 everywhere, at the jumps too.',
  },
  mod: {
    value: 'x - divisor * floor(x / divisor)',
    by: ['1', '-floor(x / divisor)'],
    plot: ['x.mod(1.5)'],
    remark:
      'The derivative with respect to `x` is 1 everywhere, with respect to the divisor -floor(x / divisor).',
  },
  min: {
    value: 'x <= y ? x : y',
    by: ['x <= y ? 1 : 0', 'x <= y ? 0 : 1'],
    plot: ['x.min(1)'],
    remark: operandRemark,
  },
  max: {
    value: 'x >= y ? x : y',
    by: ['x >= y ? 1 : 0', 'x >= y ? 0 : 1'],
    plot: ['x.max(1)'],
    remark: operandRemark,
  },
  clamp: {
    value: 'min(max(x, low), high)',
    by: [
      'low <= x && x <= high ? 1 : 0',
      'x < low && low <= high ? 1 : 0',
      'max(x, low) > high ? 1 : 0',
    ],
    plot: ['x.clamp(-1, 1)'],
    remark: 'The derivative is that of the operand whose value is taken, bounds included.',
  },
  mix: {
    value: 'x + (y - x) * amount',
    by: ['1 - amount', 'amount', 'y - x'],
    plot: ['glsl.mix(-1, 2, x)', -0.5, 1.5],
  },
  step: {
    value: 'x < edge ? 0 : 1',
    by: ['0', '0'],
    plot: ['glsl.step(0.5, x)'],
    remark: 'The derivative is 0 everywhere, at the edge too.',
  },
  smoothstep: {
    value: 't * t * (3 - 2 * t)',
    by: [
      '6 * t * (1 - t) * (t - 1) / (high - low)',
      '-6 * t * (1 - t) * t / (high - low)',
      '6 * t * (1 - t) / (high - low)',
    ],
    where: { t: 'clamp((x - low) / (high - low), 0, 1)' },
    plot: ['glsl.smoothstep(-1, 1, x)', -2, 2],
  },
  lt: { value: 'x < y ? 1 : 0', by: ['0', '0'], plot: ['x.lt(1)'], remark: conditionRemark },
  le: { value: 'x <= y ? 1 : 0', by: ['0', '0'], plot: ['x.le(1)'], remark: conditionRemark },
  gt: { value: 'x > y ? 1 : 0', by: ['0', '0'], plot: ['x.gt(1)'], remark: conditionRemark },
  ge: { value: 'x >= y ? 1 : 0', by: ['0', '0'], plot: ['x.ge(1)'], remark: conditionRemark },
  eq: {
    value: 'x == y ? 1 : 0',
    by: ['0', '0'],
    plot: ['x.floor().eq(1)'],
    remark: conditionRemark,
  },
  ne: {
    value: 'x != y ? 1 : 0',
    by: ['0', '0'],
    plot: ['x.floor().ne(1)'],
    remark: conditionRemark,
  },
  and: {
    value: 'x != 0 && y != 0 ? 1 : 0',
    by: ['0', '0'],
    plot: ['x.gt(-1).and(x.lt(1))'],
    remark: conditionRemark,
  },
  or: {
    value: 'x != 0 || y != 0 ? 1 : 0',
    by: ['0', '0'],
    plot: ['x.lt(-1).or(x.gt(1))'],
    remark: conditionRemark,
  },
  not: { value: 'x != 0 ? 0 : 1', by: ['0'], plot: ['x.lt(1).not()'], remark: conditionRemark },
  ifElse: {
    value: 'condition != 0 ? yes : no',
    by: ['0', 'condition != 0 ? 1 : 0', 'condition != 0 ? 0 : 1'],
    plot: ['x.lt(0).ifElse(x.neg(), x.mult(x))'],
    remark: 'The derivative is that of the value that is taken; a jump between the two is ignored.',
  },
}
