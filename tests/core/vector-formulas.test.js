// Tests the formulas of operations on vectors and matrices in the docs: evaluates their text in double precision, checks each derivative
// against finite differences of the value, and checks warpjet's values and derivatives against both.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { vectorFormulas } from '../../.scripts/reference/vector-formulas.mjs'
import { compile } from '../../dist/warpjet.js'
import { add, times, transpose } from '../support/linear.js'
import { evaluateFormula } from '../support/notation.js'
import { lettersOf, turns } from '../support/plain-builder.js'

const isScalar = (letter) => /^[sφη]$/.test(letter)
const isMatrix = (letter) => /^[A-Z]$/.test(letter)
const isRotation = (form) => form.endsWith(') v')
const isAdjusted = (form) => form.startsWith('adjust')

/**
 * Returns the letters of the inputs of a formula. The position and the offset have no letters: only F, the Jacobian of their sum,
 * matters.
 */
function lettersIn(form) {
  const letters = lettersOf(form)
  if (isRotation(form)) return [...letters, 'v']
  if (isAdjusted(form)) return ['F', ...letters.slice(1, -1)]
  return letters
}

const sizesOf = (form) => (/cross|rotate|adjust/.test(form) ? [3] : [2, 3, 4])

let counter = 0
/** Returns pseudorandom numbers from -1.5 to 1.5. */
const nextNumber = () => 1.5 * Math.sin(0.7 * ++counter * counter + 12.9 * counter)
const list = (n, make) => Array.from({ length: n }, make)
const randomOperand = (letter, n) => {
  if (isScalar(letter)) return nextNumber()
  if (!isMatrix(letter)) return list(n, nextNumber)
  // Matrices that are far from singular, with a diagonal of either sign.
  const sign = Math.sign(nextNumber())
  return list(n, (_, i) => list(n, (_, j) => nextNumber() + (i === j ? 3 * sign : 0)))
}
// `place` maps each letter → the value of that input, `changes` maps it → the derivative of the input with respect to t.
const moveAlong = (place, changes, t) =>
  Object.fromEntries(
    Object.entries(place).map(([letter, x]) => [letter, add(x, times(t, changes[letter]))]),
  )

const withRotations = (values, count) => ({ ...turns, ...values, count })
const valueOf = ({ value, where }, place, n) =>
  evaluateFormula(value, withRotations(place, n), where)

function derivativeOf(formula, place, changes, n) {
  const named = Object.entries(changes).map(([letter, x]) => [`d${letter}`, x])
  const variables = withRotations({ ...place, ...Object.fromEntries(named) }, n)
  const w = formula.where?.w ? {} : { w: valueOf(formula, place, n) }
  return evaluateFormula(formula.derivative, { ...variables, ...w }, formula.where)
}

const parameter = (glsl, letter, name, n) => {
  if (isScalar(letter)) return glsl.param(name)
  return isMatrix(letter) ? glsl[`mat${n}Param`](name) : glsl[`vec${n}Param`](name)
}

function buildResult(glsl, title, form, operands) {
  const name = title.replace(/\(.*/, '')
  if (isRotation(form)) return glsl[name](...operands.slice(0, -1)).mult(operands.at(-1))
  if (!isAdjusted(form)) return glsl[name](...operands)
  const position = glsl.vec3Param('position')
  const offset = operands[0].sub(glsl.mat3(1)).mult(position)
  return glsl[name](offset, ...operands.slice(1), position)
}

/** Compiles an operation; its program returns the value and the derivative along the changes, with respect to t. */
function programOf(title, n) {
  const { form } = vectorFormulas[title]
  return compile((glsl) => {
    const t = glsl.param('time')
    const operands = lettersIn(form).map((letter, i) =>
      parameter(glsl, letter, `at${i}`, n).add(parameter(glsl, letter, `by${i}`, n).mult(t)),
    )
    const value = buildResult(glsl, title, form, operands)
    return { value, derivative: glsl.derivative(value, t) }
  })
}

const columnMajorNumbers = (x) => (Array.isArray(x?.[0]) ? transpose(x).flat() : [x].flat())
const toInput = (x) => (Array.isArray(x) ? columnMajorNumbers(x) : x)
const inputsOf = (place, changes) => ({
  time: 0,
  position: [0.1, 0.2, 0.3],
  ...Object.fromEntries(
    Object.keys(place).flatMap((letter, i) => [
      [`at${i}`, toInput(place[letter])],
      [`by${i}`, toInput(changes[letter])],
    ]),
  ),
})

function assertNear(actual, expected, bound, what) {
  // The docs write `0` for a zero vector too.
  const numbers =
    expected === 0 ? columnMajorNumbers(actual).map(() => 0) : columnMajorNumbers(expected)
  assert.equal(columnMajorNumbers(actual).length, numbers.length, what)
  const scale = Math.max(1, ...numbers.map(Math.abs))
  for (const [i, x] of columnMajorNumbers(actual).entries())
    assert.ok(
      Math.abs(x - numbers[i]) <= bound * scale,
      `${what}: ${columnMajorNumbers(actual)}, not ${numbers}`,
    )
}

for (const [title, formula] of Object.entries(vectorFormulas))
  describe(`${formula.form} is ${formula.value}, its derivative ${formula.derivative},`, () => {
    for (const n of sizesOf(formula.form))
      test(`in ${n} dimensions`, () => {
        const program = programOf(title, n)
        for (let i = 0; i < 12; i++) {
          const letters = lettersIn(formula.form)
          const place = Object.fromEntries(
            letters.map((letter) => [letter, randomOperand(letter, n)]),
          )
          const changes = Object.fromEntries(
            letters.map((letter) => [letter, randomOperand(letter, n)]),
          )
          const [value, derivative] = [
            valueOf(formula, place, n),
            derivativeOf(formula, place, changes, n),
          ]
          const [after, before] = [1e-6, -1e-6].map((t) =>
            valueOf(formula, moveAlong(place, changes, t), n),
          )
          if (value !== 0)
            assertNear(derivative, times(5e5, add(after, times(-1, before))), 1e-6, 'differences')
          const actual = program.evaluate(inputsOf(place, changes))
          assertNear(actual.value, value, 1e-9, 'value of warpjet')
          assertNear(actual.derivative, derivative, 1e-8, 'derivative of warpjet')
        }
      })
  })

/** Returns warpjet's value of an operation at a place, and the derivative along the changes. */
function evaluateAt(title, place, changes) {
  const n = Object.values(place).find(Array.isArray).length
  return programOf(title, n).evaluate(inputsOf(place, changes))
}

describe('where there is no derivative', () => {
  const [zero, one, up, oblique] = [[0, 0], [1, 0], [0, 1], [0.3, -0.7]] // prettier-ignore

  test('length, dist and distance of a zero vector have the derivative 0', () => {
    assert.equal(evaluateAt('length', { v: zero }, { v: oblique }).derivative, 0)
    for (const name of ['dist', 'distance'])
      assert.equal(evaluateAt(name, { a: one, b: one }, { a: oblique, b: up }).derivative, 0)
  })

  test('normalize of a zero vector is 0 and has the derivative 0', () => {
    const { value, derivative } = evaluateAt('normalize', { a: zero }, { a: oblique })
    assert.deepEqual([...value, ...derivative].map(Math.abs), [0, 0, 0, 0])
  })

  test('at grazing incidence, the derivative of refract omits the square root', () => {
    const actual = evaluateAt('refract', { i: one, n: up, η: 1 }, { i: zero, n: oblique, η: 0.5 })
    // η = 1, c = 0, k = 0: dη i + η di − (dη c + η dc + 0) n − 0, where dc = dn · i.
    assertNear(actual.derivative, [0.5, -0.3], 1e-12, 'refract')
  })

  test('faceforward flips where the vectors are exactly perpendicular', () => {
    const actual = evaluateAt(
      'faceforward',
      { n: up, i: one, r: up },
      { n: oblique, i: zero, r: zero },
    )
    assertNear(actual.value, [0, -1], 0, 'value')
    assertNear(actual.derivative, [-0.3, 0.7], 0, 'derivative')
  })

  test('a determinant of 0 has the limit of the formula as its derivative', () => {
    const [A, dA] = [[[1, 2], [2, 4]], [[0.3, 0.1], [-0.4, 0.2]]] // prettier-ignore
    const { value, derivative } = evaluateAt('determinant', { A }, { A: dA })
    // A₁₁ A₂₂ − A₁₂ A₂₁ by the product rule.
    assert.equal(value, 0)
    assert.ok(Math.abs(derivative - (0.3 * 4 + 1 * 0.2 - 0.1 * 2 - 2 * -0.4)) < 1e-12)
  })

  test('an inverse is not finite if the determinant is 0', () => {
    const { value, derivative } = evaluateAt(
      'inverse',
      { A: [[1, 2], [2, 4]] }, // prettier-ignore
      { A: [[0.3, 0.1], [-0.4, 0.2]] }, // prettier-ignore
    )
    assert.ok([...value, ...derivative].every((x) => !Number.isFinite(x)))
  })

  test('a rotation about a zero axis scales by cos(φ)', () => {
    const place = { a: [0, 0, 0], φ: 0.5, v: [1, 2, 3] }
    const actual = evaluateAt('rotate', place, { a: [0.1, 0.2, 0.3], φ: 1, v: [0, 0, 0] })
    assertNear(actual.value, times(Math.cos(0.5), place.v), 1e-12, 'value')
    assertNear(actual.derivative, times(-Math.sin(0.5), place.v), 1e-12, 'derivative')
  })

  test('a collapsed normal or tangent is 0 and has the derivative 0', () => {
    const [flat, dF] = [[[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[1, 2, 3], [0, 1, 2], [2, 2, 1]]] // prettier-ignore
    const [t, n, unchanged] = [[1, 0, 0], [0, 0, 1], [0, 0, 0]] // prettier-ignore
    const normal = evaluateAt('adjustNormal', { F: flat, n }, { F: dF, n: unchanged })
    const tangent = evaluateAt(
      'adjustTangent',
      { F: flat, t, n },
      { F: dF, t: unchanged, n: unchanged },
    )
    for (const { value, derivative } of [normal, tangent])
      assert.deepEqual([...value, ...derivative].map(Math.abs), [0, 0, 0, 0, 0, 0])
  })
})

test('second derivatives exist and are symmetric', () => {
  // The expected derivatives of f = sin(p₁) p₂² and of (f, p₁ p₂) were derived by hand.
  const program = compile((glsl) => {
    const p = glsl.vec2Param('p')
    const f = p.x().sin().mult(p.y().pow(2))
    const derivativesOf = (value) => [p.x(), p.y()].map((input) => glsl.derivative(value, input))
    const [hx, hy] = derivativesOf(f.gradient(p))
    const [jx, jy] = derivativesOf(glsl.vec2(f, p.x().mult(p.y())).jacobian(p))
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
