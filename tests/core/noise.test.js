// Properties of noise that do not depend on its values: consistent derivatives, continuity, range, no preferred direction,
// uncorrelated seeds; and properties of its shader code. tests/core/noise-oracle.test.js checks the values.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { WarpError, compile, compileWarp } from '../../dist/warpjet.js'
import {
  isFractal,
  kindsOfNoise,
  noisePoints,
  propertiesOf,
  settingsOf,
} from '../operations/noise.js'
import { components } from '../operations/program.js'
import { randomOf } from '../random/generate.js'

const makers = ['param', 'vec2Param', 'vec3Param', 'vec4Param']
const range = (n) => Array.from({ length: n }, (_, i) => i)

/**
 * Compiles a kind of noise to a function that maps a point → an array of numbers. `derive` makes further expressions from each value of the
 * noise.
 */
function evaluatorOf({ kind, dimensions }, options, derive = () => []) {
  const { evaluate } = compile((glsl) => {
    const p = glsl[makers[dimensions - 1]]('p')
    const noise = glsl[kind](p, options)
    const values = components(noise, propertiesOf[kind].size)
    const all = [
      ...values,
      ...values.flatMap((value) => derive(glsl, value, components(p, dimensions))),
    ]
    return Object.fromEntries(all.map((expression, i) => [`v${i}`, expression]))
  })
  return (point) => Object.values(evaluate({ p: point }))
}

const moveBy = (point, axis, by) => point.map((x, i) => (i === axis ? x + by : x))

/** Makes derivatives of order 1 to 3, with respect to the last input, the first one, and the last one again. */
const differentiateThrice = (glsl, value, inputs) => {
  const first = glsl.derivative(value, inputs.at(-1))
  const second = glsl.derivative(first, inputs[0])
  return [first, second, glsl.derivative(second, inputs.at(-1))]
}

describe('derivatives up to order 3 equal differences:', () => {
  for (const noise of kindsOfNoise)
    test(`${noise.kind} of ${noise.dimensions} dimensions`, () => {
      const all = evaluatorOf(noise, settingsOf(noise.kind), differentiateThrice)
      const { size } = propertiesOf[noise.kind]
      const axes = [noise.dimensions - 1, 0, noise.dimensions - 1]
      const h = 1e-5
      for (const point of noisePoints(noise.dimensions, 12)) {
        const center = all(point)
        axes.forEach((axis, order) => {
          const before = all(moveBy(point, axis, -h)),
            after = all(moveBy(point, axis, h))
          for (const value of range(size)) {
            const indexOf = (i) => (i === 0 ? value : size + 3 * value + i - 1)
            const difference = (after[indexOf(order)] - before[indexOf(order)]) / (2 * h)
            const error = Math.abs(difference - center[indexOf(order + 1)])
            const bound = 1e-4 * (1 + Math.abs(difference)) * (isFractal(noise.kind) ? 10 : 1)
            assert.ok(
              error <= bound,
              `order ${order + 1} at ${point}: ${center[indexOf(order + 1)]}, not ${difference}`,
            )
          }
        })
      }
    })
})

describe('values and slopes do not jump across borders of cells:', () => {
  const slopes = (glsl, value, inputs) => inputs.map((input) => glsl.derivative(value, input))
  for (const noise of kindsOfNoise.filter(({ dimensions }) => dimensions < 4))
    test(`${noise.kind} of ${noise.dimensions} dimensions`, () => {
      const all = evaluatorOf(noise, {}, slopes)
      const { hasKinks, size } = propertiesOf[noise.kind]
      const random = randomOf(noise.dimensions)
      const step = 1e-7
      for (let i = 0; i < 200; i++) {
        const axis = i % noise.dimensions
        const half = noise.kind === 'worley' ? 0.5 * (i % 2) : 0
        const border = Math.floor(20 * random()) - 10 + half
        const point = range(noise.dimensions).map((k) => (k === axis ? border : 20 * random() - 10))
        const before = all(moveBy(point, axis, -step)),
          after = all(moveBy(point, axis, step))
        before.slice(0, hasKinks ? size : undefined).forEach((value, k) => {
          const jump = Math.abs(after[k] - value)
          const advice = 'a noise with such slopes needs hasKinks in tests/operations/noise.js'
          assert.ok(
            jump < 1e-4,
            k < size
              ? `value ${k} jumps by ${jump} at ${point}`
              : `slope ${k - size} jumps by ${jump} at ${point}; ${advice}`,
          )
        })
      }
    })
})

/** Returns mean, standard deviation, minimum and maximum of values. */
function statisticsOf(values) {
  const mean = values.reduce((sum, x) => sum + x, 0) / values.length
  const variance = values.reduce((sum, x) => sum + (x - mean) ** 2, 0) / values.length
  return {
    mean,
    deviation: Math.sqrt(variance),
    min: Math.min(...values),
    max: Math.max(...values),
  }
}

describe('range, mean and spread:', () => {
  for (const noise of kindsOfNoise.filter(({ kind }) => kind !== 'curl'))
    test(`${noise.kind} of ${noise.dimensions} dimensions`, () => {
      const at = evaluatorOf(noise, {})
      const random = randomOf(noise.dimensions)
      const points = range(3000).map(() =>
        range(noise.dimensions).map(() => 4091 * random() - 2045),
      )
      const actual = statisticsOf(points.map((point) => at(point)[0]))
      const [low, high] = propertiesOf[noise.kind].range
      const { min, max, mean } = actual
      assert.ok(
        min >= low && max <= high,
        `values from ${min} to ${max}, not within the range of tests/operations/noise.js, ${low} to ${high}`,
      )
      if (low === -high)
        assert.ok(
          Math.abs(mean) < 0.03,
          `the mean is ${mean}; a noise that is not around 0 needs a range in tests/operations/noise.js`,
        )
      assert.ok(
        actual.deviation > 0.05 && actual.deviation < 0.6,
        `the spread is ${actual.deviation}`,
      )
    })
})

/** Returns the correlation, from -1 to 1, between the values at points and at the same points shifted by `by`. */
function correlation(at, by, random) {
  const pairs = range(4000).map(() => {
    const point = by.map(() => 400 * random())
    return [at(point)[0], at(point.map((x, i) => x + by[i]))[0]]
  })
  const sides = [0, 1].map((side) => statisticsOf(pairs.map((pair) => pair[side])))
  const [a, b] = sides
  const product = pairs.reduce((sum, [x, y]) => sum + (x - a.mean) * (y - b.mean), 0) / pairs.length
  return product / (a.deviation * b.deviation)
}

describe('there is no visible repetition in any direction:', () => {
  const offsets = [
    [1, 0],
    [0, 1],
    [1, 1],
    [1, -1],
    [2, 0],
    [0, 2],
    [2, 1],
    [3, 5],
    [17, 0],
    [0, 17],
    [64, 0],
    [0, 64],
  ]
  for (const kind of ['noise', 'valueNoise'])
    test(kind, () => {
      const at = evaluatorOf({ kind, dimensions: 2 }, {})
      for (const by of offsets) {
        // Neighbouring cells share corners, so that noise is anticorrelated there; cells further away are uncorrelated.
        const sharesCorners = Math.max(...by.map(Math.abs)) < 2
        const actual = correlation(at, by, randomOf(5))
        assert.ok(Math.abs(actual) < (sharesCorners ? 0.45 : 0.06), `${by}: ${actual}`)
      }
    })

  test('different seeds are uncorrelated fields', () => {
    const fields = [0, 1, 2, -1, 1000].map((seed) =>
      evaluatorOf({ kind: 'noise', dimensions: 2 }, { seed }),
    )
    const random = randomOf(9)
    const points = range(2000).map(() => [400 * random(), 400 * random()])
    const values = fields.map((at) => points.map((point) => at(point)[0]))
    values.forEach((a, i) =>
      values.slice(i + 1).forEach((b, k) => {
        const product = a.reduce((sum, x, n) => sum + x * b[n], 0)
        const sizes = [a, b].map((list) => Math.sqrt(list.reduce((sum, x) => sum + x * x, 0)))
        assert.ok(Math.abs(product / (sizes[0] * sizes[1])) < 0.1, `fields ${i} and ${i + 1 + k}`)
      }),
    )
  })
})

test('a curl has no divergence', () => {
  for (const dimensions of [3, 4]) {
    const at = evaluatorOf({ kind: 'curl', dimensions }, {}, (glsl, value, inputs) =>
      inputs.slice(0, 3).map((input) => glsl.derivative(value, input)),
    )
    for (const point of noisePoints(dimensions, 20)) {
      const [, , , ...slopes] = at(point)
      const divergence = slopes[0] + slopes[4] + slopes[8]
      assert.ok(Math.abs(divergence) < 1e-9 && slopes.some((slope) => Math.abs(slope) > 0.1))
    }
  }
})

describe('the code of a noise', () => {
  const targets = ['glsl300', 'glsl100', 'wgsl']
  const count = (text, part) => text.split(part).length - 1

  test('is one function, which is called once for a value and its derivatives', () => {
    for (const target of targets) {
      const { code, declarations } = compile(
        (glsl) => {
          const p = glsl.vec3Param('p')
          const n = p.noise()
          return { n, slope: glsl.gradient(n, p) }
        },
        { target },
      )
      assert.equal(count(code, 'warpjetNoise3Gradient('), 1)
      assert.equal(count(declarations, 'warpjetNoise3Gradient('), 1)
      assert.equal(count(declarations, 'warpjetNoise3('), 0)
    }
  })

  test('is defined once for calls at several points and with several seeds', () => {
    const { code, declarations } = compile((glsl) => {
      const p = glsl.vec2Param('p')
      return { sum: p.fbm().add(p.mult(3).fbm({ seed: 4 }), p.noise({ seed: 2 })) }
    })
    assert.equal(count(code, 'warpjetFbm2Noise5('), 2)
    assert.equal(count(declarations, 'float warpjetFbm2Noise5('), 1)
    assert.equal(count(declarations, 'float warpjetNoise2('), 1)
    assert.equal(count(declarations, 'float warpjetHash('), 1)
  })

  test('uses unsigned integers for its hash if the language has them', () => {
    const text = (target) =>
      compile((glsl) => ({ n: glsl.param('x').noise() }), { target }).declarations
    assert.match(text('glsl300'), /uint/)
    assert.match(text('wgsl'), /u32/)
    assert.doesNotMatch(text('glsl100'), /uint|%/)
    for (const target of targets) assert.doesNotMatch(text(target), /\bsin\b|43758/)
  })

  test('accepts expressions as gain and lacunarity, and differentiates with respect to them', () => {
    const { evaluate } = compile((glsl) => {
      const x = glsl.param('x')
      const n = x.fbm({ gain: x.mult(0.1), lacunarity: x.add(1) })
      return { n, slope: glsl.derivative(n, x) }
    })
    const h = 1e-6
    const difference = (evaluate({ x: 2.3 + h }).n - evaluate({ x: 2.3 - h }).n) / (2 * h)
    assert.ok(
      Math.abs(evaluate({ x: 2.3 }).slope - difference) < 1e-6 * Math.abs(difference) + 1e-6,
    )
  })
})

describe('a warp of noise on the CPU', () => {
  const warp = compileWarp(({ glsl, position, millis }) => {
    const p = position.mult(0.02)
    return glsl
      .vec3(p.fbm(), p.simplex({ seed: 1 }), glsl.vec4(p, millis.div(1000)).noise())
      .mult(20)
  })
  const positions = Float32Array.from({ length: 3000 }, (_, i) => 100 * Math.sin(i * i))
  const normals = positions.map((_, i) => Number(i % 3 === 2))

  test('has the same values in float32 and in double precision', () => {
    const { evaluate } = compile((glsl) => {
      const p = glsl.vec3Param('position').mult(0.02)
      const time = glsl.param('millis').div(1000)
      return {
        offset: glsl.vec3(p.fbm(), p.simplex({ seed: 1 }), glsl.vec4(p, time).noise()).mult(20),
      }
    })
    const moved = warp.evaluate({ positions, normals }, { uniforms: { millis: 700 } })
    for (let i = 0; i < positions.length; i += 3) {
      const position = [...positions.subarray(i, i + 3)]
      const { offset } = evaluate({ position, millis: 700 })
      offset.forEach((x, k) =>
        assert.ok(Math.abs(moved.positions[i + k] - position[k] - x) < 20 * 1e-5 + 1e-5),
      )
    }
  })

  test('has bounds from the range of the noise', () => {
    const { min, max } = warp.bounds(
      { min: [-100, -100, -100], max: [100, 100, 100] },
      { uniforms: { millis: 0 } },
    )
    assert.ok(
      [...max, ...min].every((x) => Math.abs(x) <= 120.01 && Math.abs(x) > 100),
      `${min} to ${max}`,
    )
  })
})

describe('noise throws for wrong arguments:', () => {
  const rejectedCalls = [
    [
      (glsl, p) => p.noise({ sed: 1 }),
      /^noise: there is no option "sed"; did you mean seed\? The only option is seed\.$/,
    ],
    [
      (glsl, p) => p.noise({ seed: 0.5 }),
      /^noise: expected a whole number from -8388608 to 8388608 for the option "seed", got the number 0\.5\.$/,
    ],
    [
      (glsl, p) => p.fbm({ octaves: 0 }),
      /^fbm: expected a whole number from 1 to 16 for the option "octaves", got the number 0\.$/,
    ],
    [
      (glsl, p) => p.fbm({ gain: -1 }),
      /^fbm: expected a number above 0, or an expression of one number, for the option "gain", got the number -1\.$/,
    ],
    [
      (glsl, p) => p.fbm({ gain: p }),
      /^fbm: expected a number above 0, or an expression of one number, for the option "gain", got a vec3\.$/,
    ],
    [
      (glsl, p) => p.fbm({ noise: 'perlin' }),
      /^fbm: expected 'noise', 'simplex' or 'valueNoise' for the option "noise", got the text "perlin"\.$/,
    ],
    [
      (glsl) => glsl.noise(1, 2, 3, 4),
      /^noise: it takes one point; write glsl\.vec3\(x, y, z\)\.noise\(\)\.$/,
    ],
    [
      (glsl) => glsl.noise(1, 2, 3, 4, 5),
      /^noise: it takes a point and options; the number 3 is too many\.$/,
    ],
    [
      (glsl) => glsl.vec4(1, 2, 3, 4).worley(),
      /^worley: expected a number, a vec2 or a vec3 as the value it is called on, got a vec4\.$/,
    ],
    [
      (glsl) => glsl.worley(glsl.vec4(1, 2, 3, 4)),
      /^worley: expected a number, a vec2 or a vec3 as argument 1, got a vec4\.$/,
    ],
    [
      (glsl) => glsl.curl(glsl.vec2(1, 2)),
      /^curl: expected a vec3, or a vec4 whose last number is time as argument 1, got a vec2\.$/,
    ],
    [
      (glsl, p) => glsl.noise(p, {}, 1),
      /^noise: it takes a point and options; the number 1 is too many\.$/,
    ],
    [
      (glsl) => glsl.noise(glsl.mat2(1)),
      /^noise: expected a number or a vector as argument 1, got a mat2\.$/,
    ],
    [
      (glsl, p) => range(4).reduce((value) => glsl.derivative(value, p.x()), p.noise()),
      /^derivative: derivatives of noise and textures are limited to order three; a warp's normal takes one derivative; in a chain of warps, each normal that a later warp reads takes another\.$/,
    ],
    [
      (glsl) =>
        glsl.fn({
          name: 'warpjetNoise3',
          source: 'float warpjetNoise3(float x) { return x; }',
          arity: 1,
        }),
      /^fn: "warpjetNoise3" cannot name a function: such names are reserved for warpjet; rename it\.$/,
    ],
  ]
  for (const [build, message] of rejectedCalls)
    test(String(message), () => {
      assert.throws(
        () => compile((glsl) => ({ x: build(glsl, glsl.vec3Param('p')) })),
        (error) => error instanceof WarpError && (assert.match(error.message, message), true),
      )
    })
})
