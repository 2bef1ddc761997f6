// Measures what a call allocates in JavaScript's heap.
import { Session } from 'node:inspector/promises'

/**
 * Returns the bytes of JavaScript's heap that a call allocates, whether or not they are collected. It is the minimum of several rounds: the
 * engine may compile in any round, and then allocates objects of its own, but what every call allocates is in every round.
 */
export async function bytesOf(call, calls) {
  let min = Infinity
  for (let round = 0; round < 5 && min >= 16; round++)
    min = Math.min(min, await bytesInRound(call, calls))
  return min
}

/** Measures one round with the engine's sampling profiler. */
async function bytesInRound(call, calls) {
  const session = new Session()
  session.connect()
  await session.post('HeapProfiler.startSampling', {
    samplingInterval: 256,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  })
  for (let i = 0; i < calls; i++) call()
  const { profile } = await session.post('HeapProfiler.stopSampling')
  session.disconnect()
  const total = ({ selfSize, children }) =>
    children.reduce((sum, child) => sum + total(child), selfSize)
  return total(profile.head) / calls
}
