// Checks `gen` against the API in glsl-autodiff's README: each documented call has the value and the derivatives that plain JavaScript
// computes. glsl/run.js evaluates the generated statements.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { gen } from '../../dist/autodiff.js'
import { runGlsl } from '../glsl/run.js'
import { seededRandom } from '../warps/random.js'

const { sin, cos, tan, sqrt, log, abs, sign, min, max, hypot } = Math
const clamp = (x, low, high) => min(max(x, low), high)
const mix = (a, b, t) => a + t * (b - a)
const plus = (a, b) => a + b
const times = (a, b) => a * b

function assertClose(actual, expected, tolerance, message) {
  assert.equal([actual].flat().length, [expected].flat().length, message)
  for (const [i, value] of [actual].flat().entries()) {
    const wanted = [expected].flat()[i]
    const close = abs(value - wanted) <= tolerance * max(1, abs(wanted))
    assert.ok(close, `${message}: ${value} is not ${wanted}`)
  }
}

test('the interpreter in glsl/run.js rejects invalid GLSL', () => {
  const code = 'float y; bool b = x > 1.0; { y = b ? -x : p.yx.x * 2.0; } // done'
  assert.deepEqual(runGlsl(code, { x: 3, p: [5, 7] }), { x: 3, p: [5, 7], b: true, y: -3 })
  for (const [text, message] of [
    ['float y = 1;', /y is float, its value int/],
    ['y = 1.0;', /y is not declared/],
    ['float y = t;', /t is not declared/],
    ['float t; float y = t;', /t is not set/],
    ['float x = 1.0;', /x is declared twice/],
    ['float y = p;', /y is float, its value vec2/],
    ['vec3 y = p + vec3(1.0);', /different sizes/],
    ['float y = x ? 1.0 : 2.0;', /float where bool belongs/],
    ['float y = p.z;', /\.z of vec2/],
    ['float y = sine(x);', /sine is no function/],
    ['float y = 1.0', /Expected .*";"/],
  ])
    assert.throws(() => runGlsl(text, { x: 3, p: [5, 7] }), message)
})

// Operations on numbers. A row has the forms of a call, its value, and its derivatives with respect to x, y and z, written by hand.

const random = seededRandom(7)
const anywhere = Array.from({ length: 40 }, () => [0, 1, 2].map(() => 4 * random() - 2))
const positive = anywhere.map((point) => point.map((x) => abs(x) + 0.1))
const grid = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])))

const none = () => [0, 0, 0]
const isSmallest = (x, ...others) => (x < min(...others) ? 1 : 0)
const isLargest = (x, ...others) => (x > max(...others) ? 1 : 0)

const arithmetic = [
  [[(ad) => ad.val(2.5), (ad) => ad.sqrt(6.25)], () => 2.5, none],
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
  [[(ad) => ad.sin(0.5)], () => sin(0.5), none],
  [[(ad) => ad.cos(0.5)], () => cos(0.5), none],
  [[(ad) => ad.tan(0.5)], () => tan(0.5), none],
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
    (x, y) => [isLargest(x, min(y, 0)) * isSmallest(x, 1), isSmallest(x, y) * isSmallest(y, 0), 0],
  ],
  [
    [(ad, x) => x.clamp(-0.5, 0.5), (ad, x) => ad.clamp(x, -0.5, 0.5)],
    (x) => clamp(x, -0.5, 0.5),
    (x) => [isSmallest(abs(x), 0.5), 0, 0],
  ],
  [[(ad, x) => ad.min(x), (ad, x) => ad.max(x)], (x) => x, () => [1, 0, 0]],
  [
    [(ad, x, y) => x.min(y), (ad, x, y) => ad.min(x, y)],
    (x, y) => min(x, y),
    (x, y) => [isSmallest(x, y), isSmallest(y, x), 0],
  ],
  [
    [(ad, x, y, z) => x.min(y, 0.5, z), (ad, x, y, z) => ad.min(0.5, x, y, z)],
    (x, y, z) => min(x, y, 0.5, z),
    (x, y, z) => [isSmallest(x, y, 0.5, z), isSmallest(y, x, 0.5, z), isSmallest(z, x, y, 0.5)],
  ],
  [
    [(ad, x, y) => x.max(y), (ad, x, y) => ad.max(x, y)],
    (x, y) => max(x, y),
    (x, y) => [isLargest(x, y), isLargest(y, x), 0],
  ],
  [
    [(ad, x, y, z) => x.max(y, -0.5, z), (ad, x, y, z) => ad.max(-0.5, x, y, z)],
    (x, y, z) => max(x, y, -0.5, z),
    (x, y, z) => [isLargest(x, y, -0.5, z), isLargest(y, x, -0.5, z), isLargest(z, x, y, -0.5)],
  ],
  [
    [(ad, x, y, z) => x.gt(0).ifElse(y, z), (ad, x, y, z) => ad.ifElse(x.gt(0), y, z)],
    (x, y, z) => (x > 0 ? y : z),
    (x) => (x > 0 ? [0, 1, 0] : [0, 0, 1]),
  ],
  [[(ad, x, y) => x.gt(y).ifElse(3, 4)], (x, y) => (x > y ? 3 : 4), none],
  [[(ad, x) => ad.ifElse(1, x, 4)], (x) => x, () => [1, 0, 0]],
]

/** Makes a row in which a condition selects z or 5. */
const choice = (form, isTrue) => [
  [form],
  (x, y, z) => (isTrue(x, y, z) ? z : 5),
  (x, y, z) => [0, 0, isTrue(x, y, z) ? 1 : 0],
  grid,
]

// These are in glsl-autodiff's types, but not in its README.
const conditions = [
  choice(
    (ad, x, y, z) => x.lt(y).ifElse(z, 5),
    (x, y) => x < y,
  ),
  choice(
    (ad, x, y, z) => x.le(y).ifElse(z, 5),
    (x, y) => x <= y,
  ),
  choice(
    (ad, x, y, z) => x.gt(y).ifElse(z, 5),
    (x, y) => x > y,
  ),
  choice(
    (ad, x, y, z) => x.ge(y).ifElse(z, 5),
    (x, y) => x >= y,
  ),
  choice(
    (ad, x, y, z) => x.eq(y).ifElse(z, 5),
    (x, y) => x === y,
  ),
  choice(
    (ad, x, y, z) => x.ne(y).ifElse(z, 5),
    (x, y) => x !== y,
  ),
  choice(
    (ad, x, y, z) => x.ge(1).ifElse(z, 5),
    (x) => x >= 1,
  ),
  choice(
    (ad, x, y, z) => x.lt(y).and(y.lt(z)).ifElse(z, 5),
    (x, y, z) => x < y && y < z,
  ),
  choice(
    (ad, x, y, z) => x.lt(y).or(y.lt(z)).ifElse(z, 5),
    (x, y, z) => x < y || y < z,
  ),
  choice(
    (ad, x, y, z) => x.lt(y).not().ifElse(z, 5),
    (x, y) => !(x < y),
  ),
  choice(
    (ad, x, y, z) => x.ifElse(z, 5),
    (x) => x !== 0,
  ),
  [[(ad, x) => x.abs()], abs, (x) => [sign(x), 0, 0], grid],
]

const nameOf = (form) => form.toString().replace(/^.*?=> /, '')

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

// Vectors a, b, c and a number k. A row has the forms of a call, and the value, whose differences approximate the derivatives.

const zip = (f, ...vectors) => vectors[0].map((_, i) => f(...vectors.map((vector) => vector[i])))
const dot = (a, b) => zip(times, a, b).reduce(plus)
const difference = (a, b) => zip((x, y) => x - y, a, b)
const components = ['x', 'y', 'z', 'w']

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

  // These are in its types, but not in its README.
  [[({ a }) => a.normalize()], ({ a }) => a.map((x) => x / hypot(...a))],
  [[({ a }) => a.abs()], ({ a }) => a.map(abs)],
]

/** Returns 13 numbers in random order, 0.23 apart, so that no finite difference crosses a kink. */
function spacedNumbers() {
  const numbers = Array.from({ length: 13 }, (_, i) => [random(), 0.23 * i - 1.5])
  return numbers.sort(([a], [b]) => a - b).map(([, number]) => number)
}

/** Returns the derivative with respect to one of the numbers, from central differences with Richardson extrapolation. */
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
  const places = Array.from({ length: 13 }, (_, i) => i).filter((i) => i % 4 < size)

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
            for (const i of places)
              result.outputDeriv(`by${i}`, i === 12 ? k : vectors[i >> 2][components[i % 4]]())
          })
          const f = (numbers) => value(toInputs(numbers))
          for (let round = 0; round < 10; round++) {
            const numbers = spacedNumbers()
            const { a, b, c, k } = toInputs(numbers)
            const results = runGlsl(code, { a, b, c, k })
            assertClose(results.value, f(numbers), 1e-7, `the value at ${numbers}`)
            for (const i of places)
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

describe('inputs and outputs:', () => {
  test('gen returns code, and needs no settings', () => {
    assert.equal(typeof gen((ad) => ad.param('x').output('y')), 'string')
    assert.equal(
      gen((ad) => ad.param('x').output('y'), {}),
      gen((ad) => ad.param('x').output('y')),
    )
  })

  test('each param method reads a shader variable of its size', () => {
    const code = gen((ad) => {
      ad.param('speed').mult(2).output('a')
      ad.vec2Param('uv').mult(ad.vec2(2, 3)).output('b')
      ad.vec3Param('position')
        .mult(ad.vec3(2, 3, 4))
        .output('c')
      ad.vec4Param('color')
        .mult(ad.vec4(2, 3, 4, 5))
        .output('d')
    })
    const inputs = { speed: 1, uv: [1, 1], position: [1, 1, 1], color: [1, 1, 1, 1] }
    const { a, b, c, d } = runGlsl(code, inputs)
    assert.deepEqual({ a, b, c, d }, { a: 2, b: [2, 3], c: [2, 3, 4], d: [2, 3, 4, 5] })
  })

  test('a parameter can be any expression of the shader', () => {
    const code = gen((ad) => {
      const place = ad.vec2Param('position.zx')
      place.x().mult(ad.param('position.y')).output('product')
      place.x().mult(place.y()).outputDeriv('slope', place.y())
    })
    const { product, slope } = runGlsl(code, { position: [2, 3, 5] })
    assert.deepEqual([product, slope], [15, 5])
  })

  test('a vector can be differentiated with respect to a number, and a number with respect to a component', () => {
    const code = gen((ad) => {
      const [p, time] = [ad.vec3Param('p'), ad.param('time')]
      p.scale(time).outputDeriv('velocity', time)
      ad.vec3(p.x(), p.x().mult(p.z()), 1).outputDeriv('column', p.x())
      p.dot(p).outputDeriv('byY', p.y())
    })
    const { velocity, column, byY } = runGlsl(code, { p: [2, 3, 5], time: 7 })
    assert.deepEqual([velocity, column, byY], [[2, 3, 5], [1, 5, 0], 6])
  })

  test('JavaScript’s loops and functions are unrolled and inlined', () => {
    const code = gen((ad) => {
      const double = (node) => node.mult(2)
      let x = ad.param('x')
      for (let i = 0; i < 5; i++) x = double(x)
      x.output('y')
      x.outputDeriv('slope', ad.param('x'))
    })
    const { y, slope } = runGlsl(code, { x: 3 })
    assert.deepEqual([y, slope], [96, 32])
  })
})

describe('settings:', () => {
  const offset = (ad) => {
    const [x, y, time] = ['x', 'y', 'time'].map((name) => ad.param(name))
    let height = ad.val(0)
    for (let i = 0; i < 3; i++) {
      const angle = ad.sum(height.mult(0.5), x.mult(1.5), y.mult(2.8), time.mult(0.002))
      height = height.add(ad.sin(angle))
    }
    return { x, y, height: height.mult(0.1) }
  }
  const withSlopes = (ad) => {
    const { x, y, height } = offset(ad)
    height.output('z')
    height.outputDeriv('byX', x)
    height.outputDeriv('byY', y)
  }
  const chain = (ad) => {
    let x = ad.param('x')
    for (let i = 0; i < 30; i++) x = x.sin()
    x.output('y')
  }

  /** Returns the assignments. Those to temporaries start with a type; results are declared before the code. */
  const linesOf = (text) =>
    [...text.matchAll(/^ *(float)? ?(\w+) = (.*);$/gm)].map(([, type, name, value]) => {
      return { isTemporary: type !== undefined, name, value }
    })
  const count = (text, pattern) => text.match(pattern)?.length ?? 0

  test('no setting changes a result', () => {
    const inputs = { x: 0.7, y: -0.4, time: 1234 }
    const { z, byX, byY } = runGlsl(gen(withSlopes), inputs)
    for (const maxDepthPerVariable of [1, 2, 4, 50, Infinity])
      for (const debug of [true, false]) {
        const results = runGlsl(gen(withSlopes, { maxDepthPerVariable, debug }), inputs)
        assert.deepEqual([results.z, results.byX, results.byY], [z, byX, byY])
      }
  })

  test('maxDepthPerVariable 1 writes one operation per line', () => {
    const operation = / [-+*/] |\b\w+\(/g
    for (const { name, value } of linesOf(gen(withSlopes, { maxDepthPerVariable: 1 })))
      assert.equal(count(value, operation), 1, `${name} = ${value}`)
  })

  test('maxDepthPerVariable is the maximum number of nested operations, by default 8', () => {
    for (const depth of [1, 2, 5, 8, 13]) {
      const lines = linesOf(gen(chain, { maxDepthPerVariable: depth }))
      assert.equal(lines.length, Math.ceil(30 / depth))
      for (const { value } of lines) assert.ok(count(value, /sin\(/g) <= depth, value)
    }
    assert.equal(gen(chain), gen(chain, { maxDepthPerVariable: 8 }))
  })

  test('maxDepthPerVariable Infinity condenses to as few lines as sharing allows', () => {
    assert.equal(linesOf(gen(chain, { maxDepthPerVariable: Infinity })).length, 1)
    const text = gen(withSlopes, { maxDepthPerVariable: Infinity })
    for (const { name } of linesOf(text).filter(({ isTemporary }) => isTemporary))
      assert.ok(count(text, new RegExp(`\\b${name}\\b`, 'g')) > 2, `${name} is read only once`)
  })

  test('debug writes the line of the user’s code above each statement', () => {
    const value = (ad) => offset(ad).height.output('z')
    const text = gen(value, { debug: true, maxDepthPerVariable: 4 })
    const source = readFileSync(new URL(import.meta.url), 'utf8').split('\n')
    const place = /\/\/ From .*autodiff-api\.test\.js:(\d+):(\d+)/
    const commented = [...text.matchAll(/((?: *\/\/ .*\n)+)(.*)/g)]
    assert.equal(commented.length, linesOf(text).length)
    for (const [, comments, statement] of commented) {
      assert.match(statement, / = /)
      for (const comment of comments.trimEnd().split('\n')) {
        const [, line, column] = place.exec(comment)
        assert.match(source[line - 1].slice(column - 1), /^(mult|add|sum|sin)\(/)
      }
    }
    assert.equal(text.replace(/ *\/\/.*\n/g, ''), gen(value, { maxDepthPerVariable: 4 }))
  })
})
