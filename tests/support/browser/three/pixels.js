/** Counts the pixels of two RGBA pictures that differ by more than `tolerance` in a channel. */
export function countDiffering(a, b, tolerance = 12) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    for (let k = i; k < i + 3; k++)
      if (Math.abs(a[k] - b[k]) > tolerance) {
        count++
        break
      }
  return count
}
