// Compares the formulas next to each plot in the docs with the results of warpjet.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { formulas } from '../../.scripts/reference/formulas.mjs'
import { compile } from '../../dist/warpjet.js'
import { evaluateFormula, operandsOf } from '../support/number-formulas.js'

/** The points at which each formula is evaluated. */
const pointsByName = {
  pow: [[0.4, 2.5], [1.7, -1.3]], // prettier-ignore
  asin: [[-0.6], [0.3]],
  acos: [[-0.6], [0.3]],
  atanh: [[-0.6], [0.3]],
  acosh: [[1.3], [4]],
  clamp: [[0.3, -1, 1], [-2, -1, 1], [3, -1, 1], [0.5, 1, -1]], // prettier-ignore
  smoothstep: [[-1, 2, 0.4], [-1, 2, 1.7], [-1, 2, 5]], // prettier-ignore
  eq: [[1, 2], [2, 2]], // prettier-ignore
  ne: [[1, 2], [2, 2]], // prettier-ignore
  and: [[1, 2], [0, 2], [1, 0], [0, 0]], // prettier-ignore
  or: [[1, 2], [0, 2], [1, 0], [0, 0]], // prettier-ignore
  not: [[0], [1], [-2]],
  ifElse: [[1, 2, 3], [0, 2, 3]], // prettier-ignore
}
const step = 1e-6
const needsPositive = /^(?:sqrt|inversesqrt|log2?)$/
const defaultPoints = [[1.3, 0.7, 0.2], [-1.6, 2.3, 0.6], [0.4, -0.9, 1.2]] // prettier-ignore
const pointsOf = (name, count) =>
  pointsByName[name] ??
  defaultPoints.map((point) =>
    point.slice(0, count).map(needsPositive.test(name) ? Math.abs : Number),
  )

for (const [name, { value, by, where }] of Object.entries(formulas))
  test(`${name} is ${value}, and its derivative ${by.join(', ')}`, () => {
    const names = operandsOf(name, by.length)
    const program = compile((glsl) => {
      const params = names.map((operand) => glsl.param(operand))
      const result = glsl[name.replace(/\(.*/, '')](...params)
      const derivatives = params.map((param, i) => [`by${i}`, glsl.derivative(result, param)])
      return { value: result, ...Object.fromEntries(derivatives) }
    })
    for (const place of pointsOf(name, by.length)) {
      const values = Object.fromEntries(names.map((operand, i) => [operand, place[i]]))
      const computed = program.evaluate(values)
      for (const [key, text] of [['value', value], ...by.map((text, i) => [`by${i}`, text])]) {
        const expected = evaluateFormula(text, values, where)
        const bound = 1e-12 * Math.max(1, Math.abs(expected))
        const message = `${key} of ${name} at ${place}: ${computed[key]}, not ${expected}`
        assert.ok(Math.abs(computed[key] - expected) <= bound, message)
      }
      // The derivatives in the docs are those of the value in the docs. No finite difference here crosses a jump.
      for (const [i, text] of by.entries()) {
        const [after, before] = [step, -step].map((change) =>
          evaluateFormula(value, { ...values, [names[i]]: place[i] + change }, where),
        )
        const [slope, expected] = [
          (after - before) / (2 * step),
          evaluateFormula(text, values, where),
        ]
        const message = `the derivative of ${name} by ${names[i]} at ${place}: ${slope} by finite differences, not ${expected}`
        assert.ok(Math.abs(slope - expected) <= 1e-7 * Math.max(1, Math.abs(expected)), message)
      }
    }
  })

test('every plot of the docs is below its formulas', () => {
  const text = readFileSync(new URL('../../web/docs/plots.md', import.meta.url), 'utf8')
  const sections = text.split(/^### /m).slice(1)
  assert.equal(sections.length, Object.keys(formulas).length)
  for (const section of sections) {
    const { value, by } = formulas[section.split('\n')[0]]
    assert.ok(section.includes(`Value: \`${value}\``), section)
    for (const derivative of by) assert.ok(section.includes(`\`${derivative}\``), section)
  }
})
