/** Reports a user's mistake in one sentence: the called function, the argument, the expected and the actual value. */
export class WarpError extends Error {
  override name = 'WarpError'
}
