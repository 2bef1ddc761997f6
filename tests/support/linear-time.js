// Asserts that work takes linear time.
import assert from 'node:assert/strict'

/** Returns the minimum processor time of some runs, in microseconds. Other programs affect it little. */
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
 * Asserts that the time of `work(count)` grows about linearly. Compares two counts with a ratio of 8: linear work takes 8 times as long,
 * and quadratic work 64 times. Repeats a comparison that fails, since garbage collection or the engine's compiler may have disturbed it.
 */
export async function assertLinear(work) {
  let ratio
  for (let attempt = 0; attempt < 5; attempt++) {
    ratio = (await timeOf(work, many)) / (await timeOf(work, few))
    if (ratio < 24) return
  }
  assert.fail(`expected linear time, got ${ratio.toFixed(1)} times as long for eight times as many`)
}
