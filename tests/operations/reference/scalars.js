// Operations on one number, and on vectors by component, from GLSL's definitions. A row has
// - `name`, `shapes`: lists of the operands' shapes (1 to 4 for numbers and vectors, 'mat2' to
//   'mat4');
// - `domains`, one per operand; the last one applies to all further operands; `adjust` makes the operands of a
//   point compatible;
// - `reference`, which is independent of the compiler: maps lists of numbers to a list, matrices in
//   column-major order;
// - `result`, the shape of the result, from the shapes of the operands; default: the
//   widest of them;
// - `kinks`: where it has no derivative, or jumps; without it tests fail at kinks;
// - `tolerance` and `sensitivity`: see tolerances.js;
// - `build({ glsl, call }, ...operands)`, if calling the operation with the operands is not enough;
//   `call` calls it, as a method or as a function of the builder; `note` describes the result.
import { awayFromZero, byComponent, halves, integersUpTo, span, unary } from './row.js'
import { arcCosine, exponential, sine } from './tolerances.js'

const scalar = (name, f, domain, more) => ({
  name,
  shapes: unary,
  domains: [domain],
  reference: byComponent(f),
  ...more,
})

function roundHalfToEven(x) {
  const [below, part] = [Math.floor(x), x - Math.floor(x)]
  if (part !== 0.5) return part < 0.5 ? below : below + 1
  return below % 2 === 0 ? below : below + 1
}

const integers = { at: integersUpTo(4) }
/** The factor by which 1 - x² amplifies errors near 1 and -1. */
const amplificationNearOne = (x) => 1 / Math.max(1e-7, 1 - x * x)
const amplificationNearPole = byComponent((x) => 1 / Math.abs(Math.cos(x)))

export const scalars = [
  scalar('neg', (x) => -x, span(-5, 5, { at: [0] })),
  scalar('sqrt', Math.sqrt, span(0, 9, { at: [0] }), { kinks: 'at 0' }),
  scalar('inversesqrt', (x) => 1 / Math.sqrt(x), span(0.02, 9), { tolerance: exponential }),
  scalar('sin', Math.sin, span(-7, 7, { at: [0] }), { tolerance: sine }),
  scalar('cos', Math.cos, span(-7, 7, { at: [0] }), { tolerance: sine }),
  // On either side of the poles, up to cos(x) = 0.2.
  scalar(
    'tan',
    Math.tan,
    (random) => Math.PI * Math.floor(3 * random() - 1) + span(-1.37, 1.37, { at: [0] })(random),
    {
      tolerance: sine,
      sensitivity: {
        value: amplificationNearPole,
        derivative: amplificationNearPole,
        because: '1 / cos x',
      },
    },
  ),
  scalar('asin', Math.asin, span(-1, 1, { at: [-1, 0, 1] }), {
    kinks: 'at -1 and 1',
    sensitivity: { derivative: byComponent(amplificationNearOne), because: '1 / (1 - x²)' },
  }),
  scalar('acos', Math.acos, span(-1, 1, { at: [-1, 0, 1] }), {
    kinks: 'at -1 and 1',
    tolerance: arcCosine,
    sensitivity: { derivative: byComponent(amplificationNearOne), because: '1 / (1 - x²)' },
  }),
  scalar('atan', Math.atan, span(-20, 20, { at: [0] })),
  scalar('sinh', Math.sinh, span(-4, 4, { at: [0] }), { tolerance: exponential }),
  scalar('cosh', Math.cosh, span(-4, 4, { at: [0] }), { tolerance: exponential }),
  // For large x the result is 1, rather than the quotient of two infinite numbers.
  scalar('tanh', Math.tanh, span(-5, 5, { at: [-90, 0, 50], near: [0] }), {
    tolerance: exponential,
  }),
  // Far below zero, log(x + √(x² + 1)) would be the logarithm of zero.
  scalar('asinh', Math.asinh, span(-30, 30, { at: [-1e4, 0, 1e4], near: [0] }), {
    tolerance: exponential,
  }),
  scalar('acosh', Math.acosh, span(1, 20, { at: [1, 1e4], near: [1] }), {
    kinks: 'at 1',
    tolerance: exponential,
    sensitivity: {
      derivative: byComponent((x) => x / Math.max(1e-7, x - 1)),
      because: 'x / (x - 1)',
    },
  }),
  scalar('atanh', Math.atanh, span(-0.9999, 0.9999, { at: [0], near: [-1, 0, 1] }), {
    tolerance: exponential,
    sensitivity: { derivative: byComponent(amplificationNearOne), because: '1 / (1 - x²)' },
  }),
  scalar('exp', Math.exp, span(-6, 5, { at: [0] }), { tolerance: exponential }),
  scalar('exp2', (x) => 2 ** x, span(-7, 7, { at: [0, 3] }), { tolerance: exponential }),
  scalar('log', Math.log, span(0.01, 30, { at: [1] }), { tolerance: exponential }),
  scalar('log2', Math.log2, span(0.01, 30, { at: [1, 8] }), { tolerance: exponential }),
  scalar('abs', Math.abs, span(-5, 5, { at: [0] }), { kinks: 'at 0' }),
  scalar('sign', (x) => (x > 0 ? 1 : x < 0 ? -1 : 0), span(-5, 5, { at: [0] }), { kinks: 'at 0' }),
  scalar('floor', Math.floor, span(-5, 5, integers), { kinks: 'at whole numbers' }),
  scalar('ceil', (x) => -Math.floor(-x), span(-5, 5, integers), { kinks: 'at whole numbers' }),
  scalar(
    'round',
    roundHalfToEven,
    span(-5, 5, { at: [...integersUpTo(3), ...halves(3)], near: halves(3) }),
    { kinks: 'at halves' },
  ),
  scalar('trunc', (x) => (x < 0 ? -Math.floor(-x) : Math.floor(x)), span(-5, 5, integers), {
    kinks: 'at whole numbers other than 0',
  }),
  scalar('fract', (x) => x - Math.floor(x), span(-5, 5, integers), { kinks: 'at whole numbers' }),
  scalar('radians', (x) => (x / 180) * Math.PI, span(-400, 400, { at: [0] })),
  scalar('degrees', (x) => (x / Math.PI) * 180, span(-7, 7, { at: [0] })),

  // A constant, as an operand next to an input.
  {
    name: 'val',
    only: 'builder',
    shapes: [[1]],
    domains: [awayFromZero(0.3, 3)],
    build: ({ glsl, call }, x) => glsl.mult(x, call(-2.5)),
    note: 'val(-2.5) times x',
    reference: ([x]) => [-2.5 * x],
  },
]
