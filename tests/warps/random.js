/** Returns numbers from 0 to below 1, the same ones for the same seed: Park and Miller's generator. */
export function seededRandom(seed) {
  return () => {
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
  }
}
