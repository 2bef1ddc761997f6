// Helpers for tests of derivatives: a comparison with a relative tolerance, and names of tests.
import assert from 'node:assert/strict'

const { abs, max } = Math

export const plus = (a, b) => a + b
export const times = (a, b) => a * b

export function assertClose(actual, expected, tolerance, message) {
  assert.equal([actual].flat().length, [expected].flat().length, message)
  for (const [i, value] of [actual].flat().entries()) {
    const wanted = [expected].flat()[i]
    const close = abs(value - wanted) <= tolerance * max(1, abs(wanted))
    assert.ok(close, `${message}: ${value} is not ${wanted}`)
  }
}

/** Returns the body of an arrow function, as the name of a test. */
export const nameOf = (form) => form.toString().replace(/^.*?=> /, '')
