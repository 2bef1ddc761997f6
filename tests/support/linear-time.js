// Whether work takes time in proportion to how much there is of it.
import assert from 'node:assert/strict'

/** The processor's time in microseconds, which other programs disturb little; the shortest of some runs. */
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
 * Eight times as many take eight times as long; where each is looked for among all, sixty-four times, each time that one
 * looks. A garbage collection or the engine's compiler may lengthen a run: then it is run again.
 */
export async function isLinear(work) {
  let ratio
  for (let attempt = 0; attempt < 5; attempt++) {
    ratio = (await timeOf(work, many)) / (await timeOf(work, few))
    if (ratio < 24) return
  }
  assert.fail(`eight times as many take ${ratio.toFixed(1)} times as long`)
}
