// Messages about source that a library has generated: no user has written its lines.
import { WarpError } from '../errors/errors.js'
import type { Place } from '../options/place.js'

/** Removes the line and column from the start of a message. */
export const withoutLocation = (message: string) => message.replace(/^line \d+, column \d+: /, '')

/** Reads generated source by `read`. Removes line and column from its messages: that of its error, and `cutOff`. */
export function readGenerated<Result extends { cutOff: string }>(
  place: Place,
  read: () => Result,
): Result {
  try {
    const result = read()
    return { ...result, cutOff: withoutLocation(result.cutOff) }
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    throw place.error(withoutLocation(place.withoutMethod(error.message)))
  }
}
