// A note about conditions that decide nothing: JavaScript's `if` and `?:` take each as true, and nobody would know.
import { fileOf, nameIn, stackLines } from './source-lines.js'

const noted = new Set<string>()

/** Neither ours nor made of the sketch's text by 'warpjet/operators'. */
const isSketch = (line: string) => !/\bwarpjet[\w.-]*\.js$|\/dist\/[\w./-]+\.js$/.test(fileOf(line))

/** `error` was made where the condition was; each place is noted once on a page. */
export function noteIdle(error: Error) {
  const line = stackLines(error).find(isSketch)
  const [, number] = /:(\d+):\d+\)?$/.exec(line ?? '') ?? []
  const place = number ? ` (${nameIn(line!)}, line ${number})` : ''
  if (noted.has(place)) return
  noted.add(place)
  console.warn(
    `A condition decides nothing${place}: JavaScript's if, ?:, && and ! take every condition of a warp as true; write condition.ifElse(yes, no), a.and(b), condition.not().`,
  )
}
