// Caches a result until the numbers that it depends on change.

/** Returns a function that calls `work` again only when `state` returns other numbers than before. */
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
