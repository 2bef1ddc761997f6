// Assertions about errors of the library.
import assert from 'node:assert/strict'
import { WarpError } from 'warpjet'

/** Asserts that an error is a `WarpError` whose message is one line, ends with a period or question mark, and matches `pattern`. */
export function checkWarpError(error, pattern) {
  assert.ok(error instanceof WarpError, `${error?.stack ?? error}`)
  assert.match(error.message, pattern)
  assert.match(error.message, /^[^\n]+[.?]$/)
  assert.doesNotMatch(error.message, /: undefined|\[object/)
  return true
}

/** Asserts that `work` throws a `WarpError` with a message that matches `pattern`. */
export const throwsWarpError = (work, pattern) =>
  assert.throws(work, (error) => checkWarpError(error, pattern))

/** Asserts that the promise of `work` is rejected with a `WarpError` whose message matches `pattern`. */
export const rejectsWithWarpError = (work, pattern) =>
  assert.rejects(work, (error) => checkWarpError(error, pattern))

/** Asserts `throwsWarpError` for each row [work, pattern]. */
export const throwWarpErrors = (rows) =>
  rows.forEach(([work, pattern]) => throwsWarpError(work, pattern))
