/** Returns the median of a list of numbers: the middle one, or the upper of the two middle ones. */
export const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

/** Returns how many milliseconds `work` takes. */
export function time(work) {
  const start = performance.now()
  work()
  return performance.now() - start
}

/** Returns the median milliseconds of some runs. */
export const medianTime = (runs, work) => median(Array.from({ length: runs }, () => time(work)))

/**
 * Runs the functions of `works` in turn, so that other load on the machine slows all of them alike. Each returns milliseconds; the first
 * `warmUp` rounds are not recorded. Maps each name of `works` → the milliseconds of its `runs`.
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
