// The formulas of operations on vectors and matrices in the docs. The test evaluates their text in double precision, and compares
// derivatives with differences of values, and both with results of warpjet.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { vectorFormulas } from '../../.scripts/reference/vector-formulas.mjs'
import { compile } from '../../dist/warpjet.js'
import { add, times, transpose } from '../support/linear.js'
import { evaluateFormula } from '../support/notation.js'
import { lettersOf, turns } from '../support/plain-builder.js'

const isScalar = (letter) => /^[sφη]$/.test(letter)
const isMatrix = (letter) => /^[A-Z]$/.test(letter)
const isTurn = (form) => form.endsWith(') v')
const isAdjusted = (form) => form.startsWith('adjust')

/** The inputs of a formula. Of an offset and a position, only F matters. */
function lettersIn(form) {
  const letters = lettersOf(form)
  if (isTurn(form)) return [...letters, 'v']
  if (isAdjusted(form)) return ['F', ...letters.slice(1, -1)]
  return letters
}

const sizesOf = (form) => (/cross|rotate|adjust/.test(form) ? [3] : [2, 3, 4])

/** Unordered numbers from -1.5 to 1.5. */
let turn = 0
const number = () => 1.5 * Math.sin(0.7 * ++turn * turn + 12.9 * turn)
const list = (n, make) => Array.from({ length: n }, make)
const some = (letter, n) => {
  if (isScalar(letter)) return number()
  if (!isMatrix(letter)) return list(n, number)
  // Far from singular matrices, on either side.
  const sign = Math.sign(number())
  return list(n, (_, i) => list(n, (_, j) => number() + (i === j ? 3 * sign : 0)))
}
const along = (place, changes, t) =>
  Object.fromEntries(
    Object.entries(place).map(([letter, x]) => [letter, add(x, times(t, changes[letter]))]),
  )

const withTurns = (values, count) => ({ ...turns, ...values, count })
const valueOf = ({ value, where }, place, n) => evaluateFormula(value, withTurns(place, n), where)

function derivativeOf(formula, place, changes, n) {
  const named = Object.entries(changes).map(([letter, x]) => [`d${letter}`, x])
  const known = withTurns({ ...place, ...Object.fromEntries(named) }, n)
  const w = formula.where?.w ? {} : { w: valueOf(formula, place, n) }
  return evaluateFormula(formula.derivative, { ...known, ...w }, formula.where)
}

const parameter = (glsl, letter, name, n) => {
  if (isScalar(letter)) return glsl.param(name)
  return isMatrix(letter) ? glsl[`mat${n}Param`](name) : glsl[`vec${n}Param`](name)
}

function result(glsl, title, form, operands) {
  const name = title.replace(/\(.*/, '')
  if (isTurn(form)) return glsl[name](...operands.slice(0, -1)).mult(operands.at(-1))
  if (!isAdjusted(form)) return glsl[name](...operands)
  const position = glsl.vec3Param('position')
  const offset = operands[0].sub(glsl.mat3(1)).mult(position)
  return glsl[name](offset, ...operands.slice(1), position)
}

/** The result of warpjet, with the derivative along the changes. */
function programOf(title, n) {
  const { form } = vectorFormulas[title]
  return compile((glsl) => {
    const t = glsl.param('time')
    const operands = lettersIn(form).map((letter, i) =>
      parameter(glsl, letter, `at${i}`, n).add(parameter(glsl, letter, `by${i}`, n).mult(t)),
    )
    const value = result(glsl, title, form, operands)
    return { value, derivative: glsl.derivative(value, t) }
  })
}

const flat = (x) => (Array.isArray(x?.[0]) ? transpose(x).flat() : [x].flat())
const flattenArrays = (x) => (Array.isArray(x) ? flat(x) : x)
const inputsOf = (place, changes) => ({
  time: 0,
  position: [0.1, 0.2, 0.3],
  ...Object.fromEntries(
    Object.keys(place).flatMap((letter, i) => [
      [`at${i}`, flattenArrays(place[letter])],
      [`by${i}`, flattenArrays(changes[letter])],
    ]),
  ),
})

function assertNear(found, expected, bound, what) {
  // The docs write `0` for a zero vector too.
  const numbers = expected === 0 ? flat(found).map(() => 0) : flat(expected)
  assert.equal(flat(found).length, numbers.length, what)
  const most = Math.max(1, ...numbers.map(Math.abs))
  for (const [i, x] of flat(found).entries())
    assert.ok(Math.abs(x - numbers[i]) <= bound * most, `${what}: ${flat(found)}, not ${numbers}`)
}

for (const [title, formula] of Object.entries(vectorFormulas))
  describe(`${formula.form} is ${formula.value}, its derivative ${formula.derivative},`, () => {
    for (const n of sizesOf(formula.form))
      test(`in ${n} dimensions`, () => {
        const program = programOf(title, n)
        for (let i = 0; i < 12; i++) {
          const letters = lettersIn(formula.form)
          const place = Object.fromEntries(letters.map((letter) => [letter, some(letter, n)]))
          const changes = Object.fromEntries(letters.map((letter) => [letter, some(letter, n)]))
          const [value, derivative] = [
            valueOf(formula, place, n),
            derivativeOf(formula, place, changes, n),
          ]
          const [after, before] = [1e-6, -1e-6].map((t) =>
            valueOf(formula, along(place, changes, t), n),
          )
          if (value !== 0)
            assertNear(derivative, times(5e5, add(after, times(-1, before))), 1e-6, 'differences')
          const found = program.evaluate(inputsOf(place, changes))
          assertNear(found.value, value, 1e-9, 'value of warpjet')
          assertNear(found.derivative, derivative, 1e-8, 'derivative of warpjet')
        }
      })
  })

/** The value and the derivative at a point, along changes in order. */
function at(title, place, changes) {
  const n = Object.values(place).find(Array.isArray).length
  return programOf(title, n).evaluate(inputsOf(place, changes))
}

describe('where there is no derivative', () => {
  const [zero, one, up, some3] = [[0, 0], [1, 0], [0, 1], [0.3, -0.7]] // prettier-ignore

  test('length, dist and distance of a zero vector have the derivative 0', () => {
    assert.equal(at('length', { v: zero }, { v: some3 }).derivative, 0)
    for (const name of ['dist', 'distance'])
      assert.equal(at(name, { a: one, b: one }, { a: some3, b: up }).derivative, 0)
  })

  test('normalize of a zero vector is 0 and has the derivative 0', () => {
    const { value, derivative } = at('normalize', { a: zero }, { a: some3 })
    assert.deepEqual([...value, ...derivative].map(Math.abs), [0, 0, 0, 0])
  })

  test('refract has the derivative of its other terms at grazing incidence', () => {
    const found = at('refract', { i: one, n: up, η: 1 }, { i: zero, n: some3, η: 0.5 })
    // η = 1, c = 0, k = 0: dη i + η di − (dη c + η dc + 0) n − 0, of dc = dn · i.
    assertNear(found.derivative, [0.5, -0.3], 1e-12, 'refract')
  })

  test('faceforward flips where the vectors are exactly perpendicular', () => {
    const found = at('faceforward', { n: up, i: one, r: up }, { n: some3, i: zero, r: zero })
    assertNear(found.value, [0, -1], 0, 'value')
    assertNear(found.derivative, [-0.3, 0.7], 0, 'derivative')
  })

  test('a determinant of 0 has the limit of the formula as its derivative', () => {
    const [A, dA] = [[[1, 2], [2, 4]], [[0.3, 0.1], [-0.4, 0.2]]] // prettier-ignore
    const { value, derivative } = at('determinant', { A }, { A: dA })
    // A₁₁ A₂₂ − A₁₂ A₂₁ by the product rule.
    assert.equal(value, 0)
    assert.ok(Math.abs(derivative - (0.3 * 4 + 1 * 0.2 - 0.1 * 2 - 2 * -0.4)) < 1e-12)
  })

  test('an inverse is not finite if the determinant is 0', () => {
    const { value, derivative } = at(
      'inverse',
      { A: [[1, 2], [2, 4]] }, // prettier-ignore
      { A: [[0.3, 0.1], [-0.4, 0.2]] }, // prettier-ignore
    )
    assert.ok([...value, ...derivative].every((x) => !Number.isFinite(x)))
  })

  test('a rotation about a zero axis scales by cos(φ)', () => {
    const place = { a: [0, 0, 0], φ: 0.5, v: [1, 2, 3] }
    const found = at('rotate', place, { a: [0.1, 0.2, 0.3], φ: 1, v: [0, 0, 0] })
    assertNear(found.value, times(Math.cos(0.5), place.v), 1e-12, 'value')
    assertNear(found.derivative, times(-Math.sin(0.5), place.v), 1e-12, 'derivative')
  })

  test('a collapsed normal or tangent is 0 and has the derivative 0', () => {
    const [flat, dF] = [[[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[1, 2, 3], [0, 1, 2], [2, 2, 1]]] // prettier-ignore
    const [t, n, still] = [[1, 0, 0], [0, 0, 1], [0, 0, 0]] // prettier-ignore
    const normal = at('adjustNormal', { F: flat, n }, { F: dF, n: still })
    const tangent = at('adjustTangent', { F: flat, t, n }, { F: dF, t: still, n: still })
    for (const { value, derivative } of [normal, tangent])
      assert.deepEqual([...value, ...derivative].map(Math.abs), [0, 0, 0, 0, 0, 0])
  })
})

test('second derivatives exist and are symmetric', () => {
  // f = sin(p₁) p₂² and (f, p₁ p₂), by hand.
  const program = compile((glsl) => {
    const p = glsl.vec2Param('p')
    const f = p.x().sin().mult(p.y().pow(2))
    const along = (value) => [p.x(), p.y()].map((input) => glsl.derivative(value, input))
    const [hx, hy] = along(f.gradient(p))
    const [jx, jy] = along(glsl.vec2(f, p.x().mult(p.y())).jacobian(p))
    return { twice: f.derivative(p.x()).derivative(p.x()), hx, hy, jx, jy }
  })
  const [x, y] = [0.7, -1.3]
  const [s, c] = [Math.sin(x), Math.cos(x)]
  const { twice, hx, hy, jx, jy } = program.evaluate({ p: [x, y] })
  assertNear(twice, -s * y * y, 1e-12, 'derivative')
  assertNear([...hx, ...hy], [-s * y * y, 2 * c * y, 2 * c * y, 2 * s], 1e-12, 'gradient')
  assertNear(jx, [-s * y * y, 0, 2 * c * y, 1], 1e-12, 'jacobian by p₁')
  assertNear(jy, [2 * c * y, 1, 2 * s, 0], 1e-12, 'jacobian by p₂')
})
