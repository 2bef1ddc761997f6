/** How many pixels of two pictures, bytes of red, green, blue and alpha, differ by more than `tolerance` in a colour. */
export function differing(a, b, tolerance = 12) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > tolerance)) count++
  return count
}
