// Tests whether work takes linear time.
import assert from 'node:assert/strict'

/** Returns the minimum processor time of some runs, in microseconds, which other programs disturb little. */
export async function timeOf(work, count, runs = 2) {
  const times = []
  while (times.length < runs) {
    const start = process.cpuUsage()
    await work(count)
    const { user, system } = process.cpuUsage(start)
    times.push(user + system)
  }
  return Math.min(...times)
}

export const few = 1500
export const many = 12000

/**
 * Compares sizes with a ratio of 8: linear work takes 8 times as long, and quadratic work 64 times. A garbage collection or the engine's
 * compiler may lengthen a run, which is then repeated.
 */
export async function isLinear(work) {
  let ratio
  for (let attempt = 0; attempt < 5; attempt++) {
    ratio = (await timeOf(work, many)) / (await timeOf(work, few))
    if (ratio < 24) return
  }
  assert.fail(`eight times as many take ${ratio.toFixed(1)} times as long`)
}
