// Caches a result until the numbers that it depends on change.

/** Returns a function that returns the result of `work`. It calls `work` again only when `state` returns other numbers than before. */
export function remembered<Result>(state: () => number[], work: () => Result): () => Result {
  let last: number[] | undefined
  let result: Result
  return () => {
    const current = state()
    if (last?.length !== current.length || current.some((number, i) => number !== last![i])) {
      result = work()
      last = current
    }
    return result
  }
}
