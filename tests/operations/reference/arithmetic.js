// Operations on two or more numbers, and on vectors by component. scalars.js describes rows.
import {
  awayFromZero,
  binary,
  byComponent,
  integersUpTo,
  makeOperandsMeet,
  pick,
  smallNumber,
  span,
  ternary,
} from './row.js'
import { power } from './tolerances.js'

const binaryRow = (name, f, domains, more) => ({
  name,
  shapes: binary,
  domains,
  reference: byComponent(f),
  ...more,
})

const anything = span(-3, 3, { at: [0] })
const divisor = awayFromZero(0.25, 3)

/** Operations with any number of operands, applied from left to right. */
const chainRow = (name, f, domains, more) => ({
  ...binaryRow(name, (first, ...others) => others.reduce(f, first), domains, more),
  shapes: [...binary, [1, 1, 1], [2, 1, 2], [3, 3, 3, 3], [1, 4, 1, 4]],
})

const sum = (a, b) => a + b
const product = (a, b) => a * b
const tieOptions = { kinks: 'where operands are equal', adjust: makeOperandsMeet }

const mod = (x, y) => x - y * Math.floor(x / y)

/** For `adjust`: brings some x close to a multiple of y, but not closer than 1e-4, so that float32 is on the right side. */
function nearMultiples([xs, ys], random) {
  const moved = xs.map((x, i) => {
    const y = ys[i % ys.length]
    const nearest = y * Math.round(x / y)
    return random() < 0.2 || Math.abs(x - nearest) < 1e-4 ? nearest + smallNumber(random) : x
  })
  return [moved, ys]
}

/** Rows of x to constant integer exponents, four at a time. */
const integerPowers = [-16, -12, -8, -4, 0, 4, 8, 12, 16].map((first) => {
  const exponents = first === 16 ? [16, 2, -1, -3] : [0, 1, 2, 3].map((i) => first + i)
  return {
    name: 'pow',
    note: `constant exponents ${exponents.join(', ')}`,
    shapes: [[1]],
    result: () => 4,
    domains: [
      first < 0 || first === 16 ? awayFromZero(0.6, 1.5) : span(-1.5, 1.5, { at: [0, -1] }),
    ],
    build: ({ glsl, call }, x) => glsl.vec4(...exponents.map((n) => call(x, n))),
    reference: ([x]) =>
      exponents.map((n) => {
        const repeated = Array(Math.abs(n)).fill(x).reduce(product, 1)
        return n < 0 ? 1 / repeated : repeated
      }),
  }
})

const otherPowers = [
  [0.5, 1.5, 2.5, 17],
  [-0.5, -1.7, -2.5, -20],
].map((exponents) => ({
  name: 'pow',
  note: `constant exponents ${exponents.join(', ')}`,
  shapes: [[1]],
  result: () => 4,
  domains: [exponents[0] < 0 ? span(0.5, 3) : span(0, 1.8, { at: [0] })],
  kinks: exponents[0] < 0 ? undefined : 'at 0',
  tolerance: power,
  build: ({ glsl, call }, x) => glsl.vec4(...exponents.map((n) => call(x, n))),
  reference: ([x]) => exponents.map((n) => x ** n),
}))

const constantBase = {
  name: 'pow',
  note: 'constant bases 2, 0.3 and 1',
  shapes: [[1]],
  result: () => 3,
  domains: [span(-4, 4, { at: [0] })],
  tolerance: power,
  build: ({ glsl, call }, y) => glsl.vec3(...[2, 0.3, 1].map((base) => call(glsl.val(base), y))),
  reference: ([y]) => [2, 0.3, 1].map((base) => base ** y),
}

const integerPowersByComponent = {
  name: 'pow',
  note: 'constant exponents by component -3, 2',
  shapes: [[2]],
  domains: [awayFromZero(0.5, 2)],
  build: ({ glsl, call }, v) => call(v, glsl.vec2(-3, 2)),
  reference: ([x, y]) => [1 / (x * x * x), y * y],
}

const arithmeticRows = [
  chainRow('add', sum, [anything]),
  chainRow('sub', (a, b) => a - b, [anything]),
  chainRow('mult', product, [anything]),
  chainRow('div', (a, b) => a / b, [anything, divisor]),
  binaryRow('pow', (x, y) => x ** y, [span(0.05, 4), span(-3, 3, { at: [0, 1, 2] })], {
    tolerance: power,
  }),
  ...integerPowers,
  ...otherPowers,
  constantBase,
  integerPowersByComponent,
  // Points are at least 0.05 from the origin, where all angles meet.
  binaryRow('atan', Math.atan2, [anything], {
    kinks: 'where the angle jumps from π to -π',
    adjust: ([ys, xs]) => [
      ys,
      xs.map((x, i) => {
        const y = ys[i % ys.length]
        return Math.hypot(x, y) < 0.05 ? x + (x < 0 ? -0.1 : 0.1) : x
      }),
    ],
  }),
  binaryRow('mod', mod, [span(-6, 6), divisor], {
    kinks: 'at multiples of the divisor',
    adjust: nearMultiples,
    shapes: binary.filter(([x, y]) => x >= y),
  }),
  chainRow('min', (a, b) => (b < a ? b : a), [anything], tieOptions),
  chainRow('max', (a, b) => (b > a ? b : a), [anything], tieOptions),
]

const clamp = (x, low, high) => (high < (x > low ? x : low) ? high : x > low ? x : low)
const mix = (x, y, t) => x * (1 - t) + y * t

function smoothstep(low, high, x) {
  const t = clamp((x - low) / (high - low), 0, 1)
  return t * t * (3 - 2 * t)
}

/** For `adjust`: makes the bounds at least 0.3 apart, in either order, and moves some x to or close to one of them. */
function separateBounds([lows, highs, xs], random) {
  const size = Math.max(lows.length, highs.length)
  const bounds = Array.from({ length: size }, (_, i) => [lows, highs].map((b) => b[i % b.length]))
  const areSeparate = bounds.every(([low, high]) => Math.abs(high - low) >= 0.3)
  const highsAbove = areSeparate ? highs : highs.map((_, i) => Math.max(...lows) + 0.3 + 0.1 * i)
  const nearBound = (x, i) => {
    const bound = pick([lows, highsAbove], random)
    return random() < 0.2 ? bound[i % bound.length] + smallNumber(random) : x
  }
  const swapped = lows.length === highsAbove.length && random() < 0.25
  return [...(swapped ? [highsAbove, lows] : [lows, highsAbove]), xs.map(nearBound)]
}

const ternaryRow = (name, f, domains, more) => ({
  ...binaryRow(name, f, domains, more),
  shapes: ternary,
})

const piecewise = [
  ternaryRow('clamp', clamp, [anything], {
    kinks: 'at the bounds, and where they are equal',
    adjust: makeOperandsMeet,
  }),
  ternaryRow('mix', mix, [anything, anything, span(-0.5, 1.5, { at: integersUpTo(1) })]),
  {
    ...binaryRow('step', (edge, x) => (x < edge ? 0 : 1), [anything], tieOptions),
    kinks: 'at the edge',
  },
  ternaryRow('smoothstep', smoothstep, [span(-2, 0), span(0, 2), anything], {
    kinks: 'at the bounds, where the slope bends',
    adjust: separateBounds,
  }),
]

/** Makes a row for an operation by another name, which glsl-autodiff has. */
const alias = (name, original, shapes) => ({
  ...[...arithmeticRows, ...piecewise].find((row) => row.name === original),
  name,
  shapes,
})

export const arithmetic = [
  ...arithmeticRows,
  ...piecewise,
  alias('sum', 'add', [
    [1, 1],
    [1, 1, 1, 1],
    [3, 1, 3],
  ]),
  alias('prod', 'mult', [
    [1, 1],
    [1, 1, 1, 1],
    [3, 1, 3],
  ]),
  alias('vecSum', 'add', [
    [2, 2],
    [3, 3, 3],
    [4, 4],
  ]),
  alias('vecProd', 'mult', [
    [2, 2],
    [3, 3, 3],
    [4, 4],
  ]),
  alias('vecMix', 'mix', [
    [2, 2, 1],
    [3, 3, 3],
    [4, 4, 1],
  ]),
  alias('vecClamp', 'clamp', [
    [2, 2, 2],
    [3, 1, 1],
    [4, 4, 4],
  ]),
  alias('vecMin', 'min', [
    [2, 2],
    [3, 3, 3],
    [4, 1],
  ]),
  alias('vecMax', 'max', [
    [2, 2],
    [3, 3, 3],
    [4, 1],
  ]),
]
