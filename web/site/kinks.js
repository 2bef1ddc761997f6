/**
 * Finds the jumps of a function or its derivative, including poles, by bisection between neighbouring places whose results differ.
 * The half with the larger difference is kept each time: on a slope the difference shrinks to 0, at a jump it stays.
 */
const halvings = 40

/** In radians, see sizeOf. Smaller differences do not count as jumps. */
const minJump = 1e-3

/** Returns the max difference of the values' arctangents, which stay bounded near a pole. */
const sizeOf = (a, b) =>
  Math.max(...a.map((value, i) => Math.abs(Math.atan(value) - Math.atan(b[i]))))

/** Finds the place of a jump between `a` and `b`; undefined if there is only a slope. */
function findJump(at, a, b) {
  let [left, right] = [a, b].map((x) => ({ x, results: at(x) }))
  for (let i = 0; i < halvings; i++) {
    const x = (left.x + right.x) / 2
    const middle = { x, results: at(x) }
    if (sizeOf(left.results, middle.results) >= sizeOf(middle.results, right.results))
      right = middle
    else left = middle
    if (!(sizeOf(left.results, right.results) > minJump)) return undefined
  }
  // Rounded, because bisection only approaches 0.
  return Number(right.x.toFixed(9))
}

/** @param at maps x to [value, derivative] @param places in ascending order @returns the places of all jumps between them */
export function kinksOf(at, places) {
  const span = places.at(-1) - places[0]
  const kinks = []
  for (const [i, b] of places.entries()) {
    if (!i || !(sizeOf(at(places[i - 1]), at(b)) > minJump)) continue
    const x = findJump(at, places[i - 1], b)
    const isNew = x !== undefined && !kinks.some((kink) => Math.abs(kink - x) < 1e-6 * span)
    if (isNew) kinks.push(x)
  }
  return kinks
}
