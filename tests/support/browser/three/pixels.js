/** Counts the pixels of two RGBA pictures that differ by more than `tolerance` in a channel. */
export function countDiffering(a, b, tolerance = 12) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > tolerance)) count++
  return count
}
