// Checks `gen` against the API in glsl-autodiff's README: each documented call on vectors has the value that plain JavaScript computes, and
// derivatives close to the finite differences of that value. glsl/run.js evaluates the generated statements.
import { describe, test } from 'node:test'
import { gen } from '../../dist/autodiff.js'
import { runGlsl } from '../glsl/run.js'
import { assertClose, nameOf, plus, times } from '../support/autodiff.js'
import { seededRandom } from '../warps/random.js'

const { sin, abs, min, max, hypot } = Math
const clamp = (x, low, high) => min(max(x, low), high)
const mix = (a, b, t) => a + t * (b - a)

const random = seededRandom(7)

const zip = (f, ...vectors) => vectors[0].map((_, i) => f(...vectors.map((vector) => vector[i])))
const dot = (a, b) => zip(times, a, b).reduce(plus)
const difference = (a, b) => zip((x, y) => x - y, a, b)
const components = ['x', 'y', 'z', 'w']

// A row has equivalent forms of a call on vectors a, b and c and a number k, and a function that returns its value. Finite differences of
// the value approximate the derivatives.
const vectorRows = [
  [[({ a }) => a.neg()], ({ a }) => a.map((x) => -x)],
  [[({ a, b }) => a.add(b), ({ ad, a, b }) => ad.vecSum(a, b)], ({ a, b }) => zip(plus, a, b)],
  [
    [({ a, b, c }) => a.add(b, c), ({ ad, a, b, c }) => ad.vecSum(a, b, c)],
    ({ a, b, c }) => zip((x, y, z) => x + y + z, a, b, c),
  ],
  [[({ ad, a }) => ad.vecSum(a), ({ ad, a }) => ad.vecProd(a)], ({ a }) => a],
  [[({ a, k }) => a.scale(k)], ({ a, k }) => a.map((x) => x * k)],
  [[({ a }) => a.scale(3)], ({ a }) => a.map((x) => x * 3)],
  [[({ a, b }) => a.mult(b), ({ ad, a, b }) => ad.vecProd(a, b)], ({ a, b }) => zip(times, a, b)],
  [
    [({ a, b, c }) => a.mult(b, c), ({ ad, a, b, c }) => ad.vecProd(a, b, c)],
    ({ a, b, c }) => zip((x, y, z) => x * y * z, a, b, c),
  ],
  [
    [({ a, b, k }) => a.mix(b, k), ({ ad, a, b, k }) => ad.vecMix(a, b, k)],
    ({ a, b, k }) => zip((x, y) => mix(x, y, k), a, b),
  ],
  [
    [({ a, b }) => a.mix(b, 0.25), ({ ad, a, b }) => ad.vecMix(a, b, 0.25)],
    ({ a, b }) => zip((x, y) => mix(x, y, 0.25), a, b),
  ],
  [
    [
      ({ a, b, c }) => a.clamp(b.min(c), b.max(c)),
      ({ ad, a, b, c }) => ad.vecClamp(a, ad.vecMin(b, c), ad.vecMax(b, c)),
    ],
    ({ a, b, c }) => zip((x, y, z) => clamp(x, min(y, z), max(y, z)), a, b, c),
  ],
  [
    [({ a, b, c }) => a.min(b, c), ({ ad, a, b, c }) => ad.vecMin(a, b, c)],
    ({ a, b, c }) => zip(min, a, b, c),
  ],
  [
    [({ a, b, c }) => a.max(b, c), ({ ad, a, b, c }) => ad.vecMax(a, b, c)],
    ({ a, b, c }) => zip(max, a, b, c),
  ],
  [[({ ad, a }) => ad.vecMin(a), ({ ad, a }) => ad.vecMax(a)], ({ a }) => a],
  [[({ a, b }) => a.dot(b), ({ ad, a, b }) => ad.dot(a, b)], ({ a, b }) => dot(a, b)],
  [[({ a }) => a.length(), ({ ad, a }) => ad.length(a)], ({ a }) => hypot(...a)],
  [
    [({ a, b }) => a.dist(b), ({ ad, a, b }) => ad.dist(a, b)],
    ({ a, b }) => hypot(...difference(a, b)),
  ],
  [[({ a, b, k }) => k.gt(0).vecIfElse(a, b)], ({ a, b, k }) => (k > 0 ? a : b)],
  [
    [({ ad, a, k, size }) => ad[`vec${size}`](...[k, 2, a.x(), -0.5].slice(0, size))],
    ({ a, k, size }) => [k, 2, a[0], -0.5].slice(0, size),
  ],
  [
    [({ ad, a, size }) => ad[`vec${size}`](...components.slice(0, size).map((x) => a[x]()))],
    ({ a }) => a,
  ],

  // glsl-autodiff's vectors inherit the methods of numbers, which apply to each component.
  [[({ a, b }) => a.sub(b)], ({ a, b }) => difference(a, b)],
  [[({ a, b }) => a.div(b)], ({ a, b }) => zip((x, y) => x / y, a, b)],
  [[({ a }) => a.sin()], ({ a }) => a.map(sin)],
  [[({ a }) => a.pow(2)], ({ a }) => a.map((x) => x * x)],

  // These methods are in glsl-autodiff's types, but not in its README.
  [[({ a }) => a.normalize()], ({ a }) => a.map((x) => x / hypot(...a))],
  [[({ a }) => a.abs()], ({ a }) => a.map(abs)],
]

/** Returns 13 numbers in random order, 0.23 apart, so that no finite difference crosses a kink. */
function spacedNumbers() {
  const numbers = Array.from({ length: 13 }, (_, i) => [random(), 0.23 * i - 1.5])
  return numbers.sort(([a], [b]) => a - b).map(([, number]) => number)
}

/** Returns the derivative of `f` with respect to number `i`, from central differences with Richardson extrapolation. */
function slope(f, numbers, i) {
  const at = (step) => [f(numbers.map((x, k) => (k === i ? x + step : x)))].flat()
  const central = (h) => difference(at(h), at(-h)).map((rise) => rise / (2 * h))
  return zip((coarse, fine) => (4 * fine - coarse) / 3, central(1e-3), central(5e-4))
}

for (const size of [2, 3, 4]) {
  const vectorAt = (numbers, start) => numbers.slice(start, start + size)
  const toInputs = (numbers) => {
    const [a, b, c] = [0, 4, 8].map((start) => vectorAt(numbers, start))
    return { a, b, c, k: numbers[12], size }
  }
  const usedIndices = Array.from({ length: 13 }, (_, i) => i).filter((i) => i % 4 < size)

  describe(`vec${size}:`, () => {
    for (const [forms, value] of vectorRows)
      for (const form of forms)
        test(nameOf(form), () => {
          const code = gen((ad) => {
            const vectors = ['a', 'b', 'c'].map((name) => ad[`vec${size}Param`](name))
            const [a, b, c] = vectors
            const k = ad.param('k')
            const result = form({ ad, a, b, c, k, size })
            result.output('value')
            for (const i of usedIndices)
              result.outputDeriv(`by${i}`, i === 12 ? k : vectors[i >> 2][components[i % 4]]())
          })
          const f = (numbers) => value(toInputs(numbers))
          for (let round = 0; round < 10; round++) {
            const numbers = spacedNumbers()
            const { a, b, c, k } = toInputs(numbers)
            const results = runGlsl(code, { a, b, c, k })
            assertClose(results.value, f(numbers), 1e-7, `the value at ${numbers}`)
            for (const i of usedIndices)
              assertClose(results[`by${i}`], slope(f, numbers, i), 1e-6, `by ${i} at ${numbers}`)
          }
        })
  })
}

test('a.cross(b)', () => {
  const code = gen((ad) => {
    const [a, b] = [ad.vec3Param('a'), ad.vec3Param('b')]
    a.cross(b).output('value')
    a.cross(b).outputDeriv('byX', a.x())
    a.cross(b).outputDeriv('byZ', b.z())
  })
  const { value, byX, byZ } = runGlsl(code, { a: [1, 2, 3], b: [-4, 5, 0.5] })
  assertClose(value, [-14, -12.5, 13], 1e-12, 'the value')
  assertClose(byX, [0, -0.5, 5], 1e-12, 'by a.x')
  assertClose(byZ, [2, -1, 0], 1e-12, 'by b.z')
})
