export { describe, describeShape, shorten } from './describe.js'

/** What a sketch did wrong, in one sentence: the method, the argument, what was expected, what came. */
export class WarpError extends Error {
  override name = 'WarpError'
}
