/** Returns the median of a list of numbers: the middle one, or the upper of the two middle ones. */
export const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

/** Returns how many milliseconds `work` takes. */
export function time(work) {
  const start = performance.now()
  work()
  return performance.now() - start
}

/** Calls `work` `runs` times, and returns the median of the times in milliseconds. */
export const medianTime = (runs, work) => median(Array.from({ length: runs }, () => time(work)))

/**
 * Calls the functions of the object `works` in turn, so that other load on the machine slows all of them alike. Each function returns
 * milliseconds. Returns an object that maps each name in `works` → the milliseconds of `runs` rounds; the `warmUp` rounds before them are not
 * recorded.
 */
export function timesInTurn(works, runs, warmUp = 1) {
  const times = Object.fromEntries(Object.keys(works).map((name) => [name, []]))
  for (let i = -warmUp; i < runs; i++)
    for (const [name, work] of Object.entries(works)) {
      const milliseconds = work()
      if (i >= 0) times[name].push(milliseconds)
    }
  return times
}
