// Evaluates random GLSL source on the CPU: compares values with the same function in JavaScript, and derivatives with its finite
// differences.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile } from 'warpjet'
import 'warpjet/glsl'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { randomFunction, sharedDeclarations } from '../glsl/generate.js'

const count = isRun('every random expression') ? 2000 : 400

const points = Array.from({ length: 12 }, (_, i) =>
  [0.7548776662, 0.569840291, 0.3819660113].map((step) => 2 * ((0.5 + (i + 1) * step) % 1) - 1),
)

/** Returns slopes along an axis from central differences; `undefined` at a kink or a jump, where differences of two widths disagree. */
function slopeOf(f, p, k) {
  const at = (h) => {
    const moved = [...p]
    moved[k] += h
    return f(moved)
  }
  const central = (h) => {
    const low = at(-h)
    return at(h).map((high, i) => (high - low[i]) / (2 * h))
  }
  const [wide, narrow] = [central(2e-5), central(1e-5)]
  return narrow.map((slope, i) =>
    Math.abs(slope - wide[i]) <= 1e-4 * Math.max(1, Math.abs(slope)) ? slope : undefined,
  )
}

test(`${count} random functions have correct values and Jacobians`, () => {
  const problems = []
  const compared = { values: 0, slopes: 0 }
  for (let seed = 1; seed <= count && problems.length < 5; seed++) {
    const { glsl: text, js } = randomFunction(seed)
    try {
      const compiled = compile((glsl) => {
        const p = glsl.vec3Param('p')
        const value = glsl.source(sharedDeclarations + text)(p)
        return { value, jacobian: glsl.jacobian(value, p) }
      })
      for (const p of points) {
        const { value, jacobian } = compiled.evaluate({ p })
        const expected = js(p)
        const isNear = (a, b, tolerance) => Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(b))
        // Constants of the source are rounded to float32, as in GLSL. Some functions amplify this rounding, for instance by a sine of a sum
        // of squares in every step of a loop.
        const steepest = Math.max(1, ...Array.from(jacobian, Math.abs))
        const isRight = expected.every((x, i) => isNear(value[i], x, 2e-5 * steepest))
        compared.values += 3
        if (!isRight) {
          problems.push(`${seed} at ${p}: ${value}, not ${expected}\n${text}`)
          break
        }
        for (let k = 0; k < 3; k++)
          slopeOf(js, p, k).forEach((slope, i) => {
            if (slope === undefined) return
            compared.slopes++
            if (!isNear(jacobian[3 * k + i], slope, 1e-3))
              problems.push(
                `${seed}, by ${k} at ${p}: ${jacobian[3 * k + i]}, not ${slope}\n${text}`,
              )
          })
      }
    } catch (error) {
      problems.push(`${seed}: ${error.message}\n${text}`)
    }
  }
  assert.equal(problems.length, 0, problems.join('\n\n').slice(0, 6000))
  assert.ok(compared.slopes > count * 80, `${compared.slopes} slopes were compared`)
})
