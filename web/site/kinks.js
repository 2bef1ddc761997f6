/**
 * Where a function or its derivative jumps, poles included: found by bisection between neighbouring places whose results differ.
 * Always the half with the larger difference is kept; on a slope the difference shrinks to nothing, at a jump it stays.
 */
const halvings = 40

/** Less is none. */
const smallestJump = 1e-3

/** Of angles, which are bounded where values grow to a pole. */
const sizeOf = (a, b) =>
  Math.max(...a.map((value, i) => Math.abs(Math.atan(value) - Math.atan(b[i]))))

/** The place of the jump from `a` to `b`, or nothing where the way between is a slope. */
function jumpBetween(at, a, b) {
  let [left, right] = [a, b].map((x) => ({ x, results: at(x) }))
  for (let i = 0; i < halvings; i++) {
    const x = (left.x + right.x) / 2
    const middle = { x, results: at(x) }
    if (sizeOf(left.results, middle.results) >= sizeOf(middle.results, right.results))
      right = middle
    else left = middle
    if (!(sizeOf(left.results, right.results) > smallestJump)) return undefined
  }
  // Of zero, halves come near only.
  return Number(right.x.toFixed(9))
}

/** `at(x)` → [value, derivative]; `places` in order → the places of all jumps between them. */
export function kinksOf(at, places) {
  const span = places.at(-1) - places[0]
  const kinks = []
  for (const [i, b] of places.entries()) {
    if (!i || !(sizeOf(at(places[i - 1]), at(b)) > smallestJump)) continue
    const x = jumpBetween(at, places[i - 1], b)
    const isNew = x !== undefined && !kinks.some((kink) => Math.abs(kink - x) < 1e-6 * span)
    if (isNew) kinks.push(x)
  }
  return kinks
}
