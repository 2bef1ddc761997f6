// Notes about expressions that nothing is made of: conditions, since JavaScript's `if` and `?:` take each as true and nobody would
// know, and vectors that a sketch meant to change as it would a p5.Vector.
import { fileOf, nameIn, stackLines } from './source-lines.js'

const noted = new Set<string>()

/** Neither ours nor made of the sketch's text by 'warpjet/operators'. */
const isSketch = (line: string) => !/\bwarpjet[\w.-]*\.js$|\/dist\/[\w./-]+\.js$/.test(fileOf(line))

/** Says `sentence` with the place of the sketch where `error` was made: each place is noted once on a page. */
function note(error: Error, sentence: (place: string) => string) {
  const line = stackLines(error).find(isSketch)
  const [, number] = /:(\d+):\d+\)?$/.exec(line ?? '') ?? []
  const place = number ? ` (${nameIn(line!)}, line ${number})` : ''
  if (noted.has(place)) return
  noted.add(place)
  console.warn(sentence(place))
}

export const noteIdle = (error: Error) =>
  note(
    error,
    (place) =>
      `A condition decides nothing${place}: JavaScript's if, ?:, && and ! take every condition of a warp as true; write condition.ifElse(yes, no), a.and(b), condition.not().`,
  )

export const noteUnused = (method: string, error: Error) =>
  note(
    error,
    (place) =>
      `${method}: an expression of a warp never changes, and the new one is not used${place}; write v = v.${method}(…).`,
  )
