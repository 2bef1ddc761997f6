// Notes about expressions that nothing is made of: conditions, since JavaScript's `if` and `?:` take each as true and nobody would
// know, and vectors that a sketch meant to change as it would a p5.Vector.
import { Expression } from './expression.js'
import { fileOf, nameIn, stackLines } from '../../errors/source-lines.js'

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

const noteIdle = (error: Error) =>
  note(
    error,
    (place) =>
      `A condition decides nothing${place}: JavaScript's if, ?:, && and ! take every condition of a warp as true; write condition.ifElse(yes, no), a.and(b), condition.not().`,
  )

const noteUnused = (method: string, error: Error) =>
  note(
    error,
    (place) =>
      `${method}: an expression of a warp never changes, and the new one is not used${place}; write v = v.${method}(…).`,
  )

/** The expressions of a session that nothing is made of, by their handles. */
export class UnusedExpressions {
  /** Maps the handle of an unused expression → its note for the console. */
  private readonly notes = new Map<number, () => void>()
  /** Results of `copy()`, and of methods called on them. */
  private copies: WeakSet<Expression> | undefined

  get size() {
    return this.notes.size
  }

  /** Says that something is made of it. */
  use({ handle }: Expression) {
    this.notes.delete(handle)
  }

  /** A condition is noted if nothing is made of it. */
  watch(condition: number) {
    const error = new Error()
    this.notes.set(condition, () => noteIdle(error))
  }

  /** Says that an expression is a copy: of those, a later call whose result is unused is noted, as for a p5.Vector. */
  addCopy(copy: Expression) {
    this.copies ??= new WeakSet()
    this.copies.add(copy)
  }

  /** To be called with what a method gave: of a copy it is noted if nothing is made of it. */
  follow(copy: Expression, method: string, result: unknown) {
    if (!this.copies?.has(copy) || !(result instanceof Expression)) return
    this.copies.add(result)
    if (result.handle === copy.handle) return
    const error = new Error()
    this.notes.set(result.handle, () => noteUnused(method, error))
  }

  noteAll() {
    for (const note of this.notes.values()) note()
  }
}
