/** What a user did wrong, in one sentence: the method, the argument, what was expected, what came. */
export class WarpError extends Error {
  override name = 'WarpError'
}
