// What is worked out again only when numbers have changed that it depends on.

/** Remembers what `work` gave for as long as `state` gives the same numbers. */
export function remembered<Result>(state: () => number[], work: () => Result): () => Result {
  let last: number[] | undefined
  let result: Result
  return () => {
    const now = state()
    if (last?.length !== now.length || now.some((number, i) => number !== last![i])) {
      result = work()
      last = now
    }
    return result
  }
}
