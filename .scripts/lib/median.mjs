/** Returns the number in the middle, or the upper of two. */
export const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

/** Returns how many milliseconds `work` takes. */
export function time(work) {
  const start = performance.now()
  work()
  return performance.now() - start
}

/** Returns the median milliseconds of some runs. */
export const medianTime = (runs, work) => median(Array.from({ length: runs }, () => time(work)))
