// Checks `gen` against the API in glsl-autodiff's README: each documented call on numbers has the value and the derivatives that plain
// JavaScript computes. glsl/run.js evaluates the generated statements.
import { describe, test } from 'node:test'
import { gen } from '../../dist/autodiff.js'
import { runGlsl } from '../glsl/run.js'
import { assertClose, nameOf, plus, times } from '../support/autodiff.js'
import { seededRandom } from '../warps/random.js'

const { sin, cos, tan, sqrt, log, abs, sign, min, max } = Math
const clamp = (x, low, high) => min(max(x, low), high)
const mix = (a, b, t) => a + t * (b - a)

const random = seededRandom(7)
const anywhere = Array.from({ length: 40 }, () => [0, 1, 2].map(() => 4 * random() - 2))
const positive = anywhere.map((point) => point.map((x) => abs(x) + 0.1))
const grid = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])))

const zeros = () => [0, 0, 0]
const oneIfSmallest = (x, ...others) => (x < min(...others) ? 1 : 0)
const oneIfLargest = (x, ...others) => (x > max(...others) ? 1 : 0)

// A row has equivalent forms of a call, a function that returns its value, one that returns its derivatives with respect to x, y and z
// (derived by hand), and the points where they are compared (default: `anywhere`).
const arithmetic = [
  [[(ad) => ad.val(2.5), (ad) => ad.sqrt(6.25)], () => 2.5, zeros],
  [[(ad, x) => x.neg()], (x) => -x, () => [-1, 0, 0]],
  [[(ad, x, y) => x.add(y), (ad, x, y) => ad.sum(x, y)], plus, () => [1, 1, 0]],
  [[(ad, x) => x.add(2), (ad, x) => ad.sum(2, x)], (x) => x + 2, () => [1, 0, 0]],
  [
    [(ad, x, y, z) => x.add(y, 2, z), (ad, x, y, z) => ad.sum(2, x, y, z)],
    (x, y, z) => x + y + 2 + z,
    () => [1, 1, 1],
  ],
  [[(ad, x) => ad.sum(x), (ad, x) => ad.prod(x)], (x) => x, () => [1, 0, 0]],
  [[(ad, x, y) => x.sub(y)], (x, y) => x - y, () => [1, -1, 0]],
  [[(ad, x) => x.sub(1.5)], (x) => x - 1.5, () => [1, 0, 0]],
  [[(ad, x, y) => x.mult(y), (ad, x, y) => ad.prod(x, y)], times, (x, y) => [y, x, 0]],
  [[(ad, x) => x.mult(3), (ad, x) => ad.prod(3, x)], (x) => 3 * x, () => [3, 0, 0]],
  [
    [(ad, x, y, z) => x.mult(y, 2, z), (ad, x, y, z) => ad.prod(2, x, y, z)],
    (x, y, z) => 2 * x * y * z,
    (x, y, z) => [2 * y * z, 2 * x * z, 2 * x * y],
  ],
  [[(ad, x, y) => x.div(y)], (x, y) => x / y, (x, y) => [1 / y, -x / y ** 2, 0]],
  [[(ad, x) => x.div(4)], (x) => x / 4, () => [0.25, 0, 0]],
  [
    [(ad, x, y) => x.pow(y)],
    (x, y) => x ** y,
    (x, y) => [y * x ** (y - 1), x ** y * log(x), 0],
    positive,
  ],
  [[(ad, x) => x.pow(2.5)], (x) => x ** 2.5, (x) => [2.5 * x ** 1.5, 0, 0], positive],
  [[(ad, x) => x.pow(2)], (x) => x * x, (x) => [2 * x, 0, 0]],
  [[(ad, x) => x.pow(3)], (x) => x * x * x, (x) => [3 * x * x, 0, 0]],
  [[(ad, x) => x.pow(-1)], (x) => 1 / x, (x) => [-1 / x ** 2, 0, 0]],
  [[(ad, x) => x.sqrt(), (ad, x) => ad.sqrt(x)], sqrt, (x) => [0.5 / sqrt(x), 0, 0], positive],
]

const functions = [
  [[(ad, x) => x.sin(), (ad, x) => ad.sin(x)], sin, (x) => [cos(x), 0, 0]],
  [[(ad, x) => x.cos(), (ad, x) => ad.cos(x)], cos, (x) => [-sin(x), 0, 0]],
  [[(ad, x) => x.tan(), (ad, x) => ad.tan(x)], tan, (x) => [1 / cos(x) ** 2, 0, 0]],
  [[(ad) => ad.sin(0.5)], () => sin(0.5), zeros],
  [[(ad) => ad.cos(0.5)], () => cos(0.5), zeros],
  [[(ad) => ad.tan(0.5)], () => tan(0.5), zeros],
  [
    [(ad, x, y, z) => x.mix(y, z), (ad, x, y, z) => ad.mix(x, y, z)],
    mix,
    (x, y, z) => [1 - z, z, y - x],
  ],
  [[(ad, x) => x.mix(10, 0.25)], (x) => mix(x, 10, 0.25), () => [0.75, 0, 0]],
  [[(ad, x) => ad.mix(10, 20, x)], (x) => 10 + 10 * x, () => [10, 0, 0]],
  [
    [(ad, x, y) => x.clamp(y.min(0), 1), (ad, x, y) => ad.clamp(x, y.min(0), 1)],
    (x, y) => clamp(x, min(y, 0), 1),
    (x, y) => [
      oneIfLargest(x, min(y, 0)) * oneIfSmallest(x, 1),
      oneIfSmallest(x, y) * oneIfSmallest(y, 0),
      0,
    ],
  ],
  [
    [(ad, x) => x.clamp(-0.5, 0.5), (ad, x) => ad.clamp(x, -0.5, 0.5)],
    (x) => clamp(x, -0.5, 0.5),
    (x) => [oneIfSmallest(abs(x), 0.5), 0, 0],
  ],
  [[(ad, x) => ad.min(x), (ad, x) => ad.max(x)], (x) => x, () => [1, 0, 0]],
  [
    [(ad, x, y) => x.min(y), (ad, x, y) => ad.min(x, y)],
    (x, y) => min(x, y),
    (x, y) => [oneIfSmallest(x, y), oneIfSmallest(y, x), 0],
  ],
  [
    [(ad, x, y, z) => x.min(y, 0.5, z), (ad, x, y, z) => ad.min(0.5, x, y, z)],
    (x, y, z) => min(x, y, 0.5, z),
    (x, y, z) => [
      oneIfSmallest(x, y, 0.5, z),
      oneIfSmallest(y, x, 0.5, z),
      oneIfSmallest(z, x, y, 0.5),
    ],
  ],
  [
    [(ad, x, y) => x.max(y), (ad, x, y) => ad.max(x, y)],
    (x, y) => max(x, y),
    (x, y) => [oneIfLargest(x, y), oneIfLargest(y, x), 0],
  ],
  [
    [(ad, x, y, z) => x.max(y, -0.5, z), (ad, x, y, z) => ad.max(-0.5, x, y, z)],
    (x, y, z) => max(x, y, -0.5, z),
    (x, y, z) => [
      oneIfLargest(x, y, -0.5, z),
      oneIfLargest(y, x, -0.5, z),
      oneIfLargest(z, x, y, -0.5),
    ],
  ],
  [
    [(ad, x, y, z) => x.gt(0).ifElse(y, z), (ad, x, y, z) => ad.ifElse(x.gt(0), y, z)],
    (x, y, z) => (x > 0 ? y : z),
    (x) => (x > 0 ? [0, 1, 0] : [0, 0, 1]),
  ],
  [[(ad, x, y) => x.gt(y).ifElse(3, 4)], (x, y) => (x > y ? 3 : 4), zeros],
  [[(ad, x) => ad.ifElse(1, x, 4)], (x) => x, () => [1, 0, 0]],
]

/** Makes a row in which a condition selects z or 5. */
const makeChoice = (form, isTrue) => [
  [form],
  (x, y, z) => (isTrue(x, y, z) ? z : 5),
  (x, y, z) => [0, 0, isTrue(x, y, z) ? 1 : 0],
  grid,
]

// These methods are in glsl-autodiff's types, but not in its README.
const conditions = [
  makeChoice(
    (ad, x, y, z) => x.lt(y).ifElse(z, 5),
    (x, y) => x < y,
  ),
  makeChoice(
    (ad, x, y, z) => x.le(y).ifElse(z, 5),
    (x, y) => x <= y,
  ),
  makeChoice(
    (ad, x, y, z) => x.gt(y).ifElse(z, 5),
    (x, y) => x > y,
  ),
  makeChoice(
    (ad, x, y, z) => x.ge(y).ifElse(z, 5),
    (x, y) => x >= y,
  ),
  makeChoice(
    (ad, x, y, z) => x.eq(y).ifElse(z, 5),
    (x, y) => x === y,
  ),
  makeChoice(
    (ad, x, y, z) => x.ne(y).ifElse(z, 5),
    (x, y) => x !== y,
  ),
  makeChoice(
    (ad, x, y, z) => x.ge(1).ifElse(z, 5),
    (x) => x >= 1,
  ),
  makeChoice(
    (ad, x, y, z) => x.lt(y).and(y.lt(z)).ifElse(z, 5),
    (x, y, z) => x < y && y < z,
  ),
  makeChoice(
    (ad, x, y, z) => x.lt(y).or(y.lt(z)).ifElse(z, 5),
    (x, y, z) => x < y || y < z,
  ),
  makeChoice(
    (ad, x, y, z) => x.lt(y).not().ifElse(z, 5),
    (x, y) => !(x < y),
  ),
  makeChoice(
    (ad, x, y, z) => x.ifElse(z, 5),
    (x) => x !== 0,
  ),
  [[(ad, x) => x.abs()], abs, (x) => [sign(x), 0, 0], grid],
]

for (const [title, rows] of Object.entries({ arithmetic, functions, conditions }))
  describe(`${title}:`, () => {
    for (const [forms, value, slopes, points = anywhere] of rows)
      for (const form of forms)
        test(nameOf(form), () => {
          const code = gen((ad) => {
            const params = ['x', 'y', 'z'].map((name) => ad.param(name))
            const result = form(ad, ...params)
            result.output('value')
            params.forEach((param, i) => result.outputDeriv(`by${i}`, param))
          })
          for (const [x, y, z] of points) {
            const results = runGlsl(code, { x, y, z })
            const at = `at ${x}, ${y}, ${z}`
            assertClose(results.value, value(x, y, z), 1e-7, `the value ${at}`)
            const { by0, by1, by2 } = results
            assertClose([by0, by1, by2], slopes(x, y, z), 1e-7, `the derivatives ${at}`)
          }
        })
  })
