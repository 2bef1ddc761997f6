/** Reports a user's mistake in one sentence: the method, the argument, what was expected, what was passed. */
export class WarpError extends Error {
  override name = 'WarpError'
}
