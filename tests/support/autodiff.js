// Helpers for tests of derivatives: a comparison with a relative tolerance, and names of tests.
import assert from 'node:assert/strict'

const { abs, max } = Math

export const plus = (a, b) => a + b
export const times = (a, b) => a * b

export function assertClose(actual, expected, tolerance, message) {
  assert.equal([actual].flat().length, [expected].flat().length, message)
  for (const [i, value] of [actual].flat().entries()) {
    const expectedValue = [expected].flat()[i]
    const isClose = abs(value - expectedValue) <= tolerance * max(1, abs(expectedValue))
    assert.ok(isClose, `${message}: ${value} is not ${expectedValue}`)
  }
}

/** Returns the body of an arrow function, for the name of a test. */
export const nameOf = (form) => form.toString().replace(/^.*?=> /, '')
