// 'warpjet/deformers': each deformer moves points by its documented formula and transforms normals by the exact derivative, for
// options of every form. The oracle evaluates the documented formula in plain numbers, and its finite differences.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as deformers from '../../dist/deformers.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { normalize } from '../support/browser/matrix.js'
import { angleBetween, jacobian, warpVertex } from '../support/browser/oracle.js'
import { inDouble } from '../support/compositions.js'
import { deformers as oracles } from '../warps/deformers.js'
import { seededRandom } from '../warps/random.js'

const { PI } = Math
const random = seededRandom(6)
const between = (low, high) => low + (high - low) * random()
const anyPoint = (size) => [0, 1, 2].map(() => between(-size, size))

const oblique = [1, -2, 0.5]
const center = [20, -30, 10]

/** Constant options, several sets for each deformer. The empty ones are the defaults. */
const cases = {
  twist: [
    {},
    { axis: 'x', angle: 2 * PI },
    { axis: oblique, center, angle: -1.5, length: 80 },
    { axis: [0, -3, 0] },
  ],
  bend: [
    {},
    { angle: 0.01 },
    { angle: -2.5, from: 0, to: 120 },
    { axis: 'x', along: 'z', center },
    { axis: 'y', along: 'x', angle: 3 },
    { axis: oblique, along: 'y', center, angle: 1, from: -40, to: 300 },
    { axis: 'x', angle: 1.2, from: 30, to: 31 },
  ],
  taper: [{}, { amount: 3 }, { axis: oblique, center, amount: -0.8, length: 90 }],
  bulge: [
    {},
    { center, amount: -0.7, radius: 160 },
    { axis: 'y' },
    { axis: oblique, center, amount: 0.9, radius: 60 },
  ],
  stretch: [
    {},
    { keepVolume: true },
    { axis: oblique, center, amount: -0.6, keepVolume: true },
    { axis: 'z', amount: -0.5, center },
    { amount: -1.5, keepVolume: true },
  ],
  wave: [
    {},
    { axis: oblique, direction: 'z', center, amount: 8, wavelength: 60, speed: -40 },
    { direction: [1, 1, 0], speed: 0 },
  ],
  ripple: [
    {},
    { axis: oblique, center, amount: 9, wavelength: 80, speed: 0, radius: 90 },
    { axis: 'y', wavelength: 200 },
  ],
  melt: [
    {},
    { amount: 0.9, spread: 0.4, height: 30 },
    { axis: oblique, center, ground: 70, amount: 0.3 },
  ],
  inflate: [{}, { amount: -7 }, { amount: 3, direction: oblique }],
  genie: [
    {},
    { amount: 0.2, neck: 0.3 },
    { amount: 0.8, edge: 'z' },
    { axis: oblique, center: [50, -150, 20], amount: 0.45, length: 250, edge: 'x', neck: 0.1 },
  ],
  noiseDisplace: [
    {},
    { seed: 7, speed: 0.5 },
    { amount: -9, scale: 120, center, direction: oblique },
  ],
  spherify: [{}, { amount: 0.4, center, radius: 70 }, { amount: 1.5, radius: -50 }],
  shear: [
    {},
    { axis: oblique, direction: 'z', center, amount: -1.2 },
    { axis: 'x', direction: 'y' },
  ],
}

/** The step of the finite differences. */
const step = 0.02

/** Returns the option of a deformer that disables it: if the option is 0, no point moves. */
const amountOf = (name) => (name === 'twist' || name === 'bend' ? 'angle' : 'amount')

function assertClose(actual, expected, tolerance, message) {
  actual.forEach((value, i) => {
    const off = Math.abs(value - expected[i])
    assert.ok(off <= tolerance, `${message ?? ''} ${actual} is not ${expected}: ${off} off`)
  })
}

const vertices = Array.from({ length: 60 }, (_, i) => ({
  position: anyPoint(150),
  normal: normalize(anyPoint(1)),
  millis: [0, 777, 5000][i % 3],
}))

for (const [name, optionSets] of Object.entries(cases))
  describe(name, () => {
    const make = deformers[name]
    for (const options of optionSets) {
      const title = JSON.stringify(options)
      const oracle = oracles[name](options)

      test(`moves points by its formula, and has its derivatives: ${title}`, () => {
        const evaluate = inDouble(make(options))
        let smooth = 0
        for (const vertex of vertices) {
          const { offset, derivatives } = evaluate(vertex)
          assertClose(offset, oracle(vertex.position, vertex), 1e-9 * 150)
          const columns = jacobian((p) => oracle(p, vertex), vertex.position, step)
          if (!columns) continue
          smooth++
          assertClose(derivatives, columns.flat(), 2e-8, `at ${vertex.position}:`)
        }
        assert.ok(smooth > 0.9 * vertices.length, `only ${smooth} points are smooth`)
      })

      test(`transforms normals: ${title}`, () => {
        const [evaluate, warp] = [inDouble(make(options)), compileWarp(make(options))]
        for (const vertex of vertices) {
          const expected = warpVertex(oracle, vertex, vertex, step)
          if (!expected.normal) continue
          const uniforms = warp.uniforms.some(({ name }) => name === 'millis')
            ? { millis: vertex.millis }
            : {}
          const { warpedNormal } = evaluate(vertex)
          const { position, normal } = warp.evaluateAt(vertex.position, {
            normal: vertex.normal,
            uniforms,
          })
          const size = Math.hypot(150, ...expected.position)
          assertClose(position, expected.position, 2e-6 * size)
          if (expected.normal.some(Boolean)) {
            const angle = angleBetween(warpedNormal, expected.normal)
            assert.ok(angle < 1e-6 * expected.sensitivity, `${angle}° at ${vertex.position}`)
            const inFloat = angleBetween(normal, expected.normal)
            assert.ok(inFloat < 0.005 * expected.sensitivity, `${inFloat}° at ${vertex.position}`)
          } else if (typeof options.axis === 'string')
            // Along other axes, rounding leaves traces of collapsed normals.
            assert.deepEqual([warpedNormal, normal].flat().filter(Boolean), [])
        }
      })
    }

    test('moves nothing at amount 0, as a constant and as a uniform', () => {
      for (const amount of [0, () => 0, ({ glsl }) => glsl.param('nothing')]) {
        const evaluate = inDouble(make({ [amountOf(name)]: amount }))
        for (const vertex of vertices) {
          const { offset, derivatives } = evaluate({ ...vertex, nothing: 0 })
          assertClose(offset, [0, 0, 0], 1e-12)
          assertClose(derivatives, Array(9).fill(0), 1e-12)
        }
      }
    })

    test('accepts options as constants, functions, expressions, and uniforms', () => {
      const full = optionSets.at(-1)
      const isComputable = ([, value]) => typeof value === 'number' || Array.isArray(value)
      const computable = Object.fromEntries(Object.entries(full).filter(isComputable))
      const withEach = (map) => ({
        ...full,
        ...Object.fromEntries(Object.entries(computable).map(([key, x]) => [key, map(x, key)])),
      })
      const readParam = (glsl, value, key) =>
        typeof value === 'number' ? glsl.param(key) : glsl.vec3Param(key)
      const warps = [
        make(withEach((value) => () => value)),
        make(
          withEach(
            (value, key) =>
              ({ glsl }) =>
                readParam(glsl, value, key),
          ),
        ),
        (inputs) => make(withEach((value, key) => readParam(inputs.glsl, value, key)))(inputs),
        (inputs) =>
          make(
            withEach((value) =>
              typeof value === 'number' ? inputs.glsl.val(value) : inputs.glsl.vec3(...value),
            ),
          )(inputs),
      ]
      const expected = inDouble(make(full))
      for (const warp of warps) {
        const evaluate = inDouble(warp)
        for (const vertex of vertices.slice(0, 10)) {
          const actual = evaluate({ ...vertex, ...computable })
          assertClose(actual.offset, expected(vertex).offset, 1e-9)
          assertClose(actual.derivatives, expected(vertex).derivatives, 1e-9)
        }
      }
    })

    test('is finite at its centre, on its axis, and far away', () => {
      for (const options of [
        ...optionSets,
        { [amountOf(name)]: ({ glsl }) => glsl.param('much') },
      ]) {
        const warp = compileWarp(make(options))
        const middle = options.center ?? (name === 'genie' ? [0, 200, 0] : [0, 0, 0])
        const along = Array.isArray(options.axis) ? options.axis : [1, 0, 0]
        const points = [middle, middle.map((x, i) => x + 50 * along[i]), [0, 0, 1e5], [0, 50, 0]]
        for (const much of [-3, -1, 0, 1e-30, 0.5, 1, 3])
          for (const point of points) {
            const values = { millis: 100, much }
            const uniforms = Object.fromEntries(
              warp.uniforms.map(({ name }) => [name, values[name]]),
            )
            const moved = warp.evaluateAt(point, { normal: [0, 0.6, 0.8], uniforms })
            for (const x of [...moved.position, ...moved.normal])
              assert.ok(Number.isFinite(x), `${moved.position} ${moved.normal} at ${point}`)
          }
      }
    })
  })

test('is finite for computed options outside their valid range', () => {
  const strange = {
    twist: { length: 0, axis: [0, 0, 0] },
    taper: { length: 0 },
    bend: { from: 5, to: 5, axis: [0, 0, 0] },
    bulge: { radius: 0 },
    wave: { wavelength: 0, direction: [0, 0, 0] },
    ripple: { wavelength: 0, radius: -1 },
    melt: { height: 0 },
    genie: { length: 0 },
    stretch: { amount: -1, keepVolume: true },
  }
  for (const [name, options] of Object.entries(strange)) {
    const readEntry = ([key, value]) => [
      key,
      value === true
        ? value
        : ({ glsl }) => (typeof value === 'number' ? glsl.param(key) : glsl.vec3Param(key)),
    ]
    const warp = compileWarp(
      deformers[name](Object.fromEntries(Object.entries(options).map(readEntry))),
    )
    const values = { ...options, millis: 50 }
    const uniforms = Object.fromEntries(warp.uniforms.map(({ name }) => [name, values[name]]))
    const { position, normal } = warp.evaluateAt([3, 4, 5], { normal: [0, 1, 0], uniforms })
    for (const x of [...position, ...normal])
      assert.ok(Number.isFinite(x), `${name}: ${position} ${normal}`)
  }
})

test('deformers move points to positions computed by hand', () => {
  const at = (warp, position, more = {}) =>
    inDouble(warp)({ position, normal: [0, 0, 1], millis: 0, ...more }).offset
  const { twist, taper, stretch, bend, spherify, shear, wave, melt, genie } = deformers
  // A quarter turn over 200 units: an eighth at 100, where z maps to (z + x) / √2.
  assertClose(at(twist(), [0, 100, 10]), [Math.SQRT1_2 * 10, 0, 10 * Math.SQRT1_2 - 10], 1e-12)
  assertClose(at(taper(), [40, 100, 8]), [-10, 0, -2], 1e-12)
  assertClose(at(stretch({ amount: 3, keepVolume: true }), [10, 10, 10]), [-5, 30, -5], 1e-12)
  // Half a circle of the radius 100 / π about the end of a line; positive angles map y to -x.
  const half = bend({ angle: PI, from: 0, to: 100 })
  assertClose(at(half, [0, 100, 0]), [-200 / PI, -100, 0], 1e-12)
  assertClose(at(half, [0, 150, 7]), [-200 / PI, -200, 0], 1e-12)
  assertClose(at(half, [0, -20, 0]), [0, 0, 0], 1e-12)
  assertClose(at(spherify(), [0, 30, 40]), [0, 30, 40], 1e-12)
  assertClose(at(shear(), [1, 10, 1]), [5, 0, 0], 1e-12)
  assertClose(at(wave(), [0, 0, 0], { millis: 750 }), [0, 20, 0], 1e-12)
  assertClose(at(melt({ amount: 1, spread: 2 }), [5, 100, 0]), [10, 0, 0], 1e-12)
  assertClose(at(genie({ amount: 1 }), [60, -50, 30]), [-60, 250, -30], 1e-12)
})

test('twist preserves volume, and so does stretch with keepVolume', () => {
  const { twist, stretch } = deformers
  for (const warp of [twist({ axis: oblique }), stretch({ keepVolume: true, amount: 0.7 })]) {
    const { evaluate } = compile((glsl) => {
      const position = glsl.vec3Param('position')
      const jacobian = warp({ glsl, position }).jacobian(position).add(glsl.mat3(1))
      return { volume: jacobian.determinant() }
    })
    for (const { position } of vertices.slice(0, 9))
      assertClose([evaluate({ position }).volume], [1], 1e-12)
  }
})

test('options and compositions get all inputs, such as uniforms', () => {
  const { chain, inSpace, mask, shear } = deformers
  const turned = [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
  const warp = chain(
    mask(shear({ amount: ({ uniforms }) => uniforms.amount }), ({ uniforms }) => uniforms.weight),
    inSpace(turned, ({ glsl, uniforms, uv }) => glsl.vec3(uniforms.weight, uv)),
  )
  const { evaluate } = compile((glsl) => {
    const normal = glsl.vec3Param('normal')
    const uniforms = { amount: glsl.param('amount'), weight: glsl.param('weight') }
    const position = glsl.vec3Param('position')
    return { offset: warp({ glsl, position, normal, uniforms, uv: glsl.vec2(7, 8) }) }
  })
  // To the right by 10 · 3 · 0.5; then x and y of the rotated space are -y and x of this one.
  const { offset } = evaluate({ position: [1, 10, 2], amount: 3, weight: 0.5 })
  assertClose(offset, [15 - 7, 0.5, 8], 1e-12)
})

test('value and derivative share their sines', () => {
  const count = (warp) => {
    const { code } = compileWarp(warp)
    return ['sin', 'cos'].map((name) => code.match(new RegExp(`\\b${name}\\(`, 'g'))?.length ?? 0)
  }
  for (const name of ['twist', 'bend', 'wave', 'ripple'])
    assert.deepEqual(count(deformers[name]()), [1, 1], name)
})

test('a wave with speed 0 reads no time', () => {
  assert.deepEqual(compileWarp(deformers.wave({ speed: 0 })).uniforms, [])
  assert.deepEqual(compileWarp(deformers.ripple({ speed: 0 })).uniforms, [])
  assert.deepEqual(compileWarp(deformers.wave()).uniforms, [{ name: 'millis', type: 'float' }])
})
