// Checks where the plots in the docs mark a jump of a function or of its derivative. The expected points were found by hand.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { plotOf } from '../../web/site/plot.js'

/** Returns the x of the kinks that a plot marks. */
const kinksOf = (call, from = -3, to = 3) =>
  [...plotOf(call, from, to).matchAll(/data-kink="([^"]+)"/g)].map(([, x]) => Number(x))

for (const [call, expected, ...range] of [
  ['x.abs()', [0]],
  ['x.sign()', [0]],
  ['x.min(1)', [1]],
  ['x.clamp(-1, 1)', [-1, 1]],
  ['glsl.step(0.5, x)', [0.5]],
  ['x.round()', [-2.5, -1.5, -0.5, 0.5, 1.5, 2.5]],
  ['x.tan()', [-Math.PI / 2, Math.PI / 2], -4, 4],
  ['glsl.div(1, x)', [0]],
])
  test(`${call} has ${expected.length === 1 ? 'a kink' : 'kinks'} at ${expected.map((x) => Number(x.toFixed(3))).join(', ')}`, () => {
    const actual = kinksOf(call, ...range)
    assert.equal(actual.length, expected.length, `${actual}`)
    for (const [i, x] of expected.entries()) assert.ok(Math.abs(actual[i] - x) < 1e-5, `${actual}`)
  })

for (const call of ['x.sin()', 'x.exp()', 'x.pow(3)', 'glsl.smoothstep(-1, 1, x)', 'x.tanh()'])
  test(`${call} has no kinks`, () => assert.deepEqual(kinksOf(call), []))
