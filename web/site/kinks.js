/**
 * Finds the jumps of a function or its derivative, including poles, by bisection between neighbouring places whose results differ.
 * Each step keeps the half with the larger difference: on a slope the difference shrinks to 0, at a jump it does not.
 */
const halvings = 40

/** The smallest difference that counts as a jump, in radians, see maxDifference. */
const minJump = 1e-3

/** Returns the max difference of the values' arctangents, which stay bounded near a pole. */
const maxDifference = (a, b) =>
  Math.max(...a.map((value, i) => Math.abs(Math.atan(value) - Math.atan(b[i]))))

/** Finds the place of a jump between `a` and `b`; undefined if there is only a slope. */
function findJump(evaluate, a, b) {
  let [left, right] = [a, b].map((x) => ({ x, results: evaluate(x) }))
  for (let i = 0; i < halvings; i++) {
    const x = (left.x + right.x) / 2
    const middle = { x, results: evaluate(x) }
    if (maxDifference(left.results, middle.results) >= maxDifference(middle.results, right.results))
      right = middle
    else left = middle
    if (!(maxDifference(left.results, right.results) > minJump)) return undefined
  }
  // Rounds the place, because bisection only approaches a jump at 0.
  return Number(right.x.toFixed(9))
}

/** @param evaluate maps x to [value, derivative] @param places in ascending order @returns the places of all jumps between them */
export function findKinks(evaluate, places) {
  const span = places.at(-1) - places[0]
  const kinks = []
  for (const [i, b] of places.entries()) {
    if (!i || !(maxDifference(evaluate(places[i - 1]), evaluate(b)) > minJump)) continue
    const x = findJump(evaluate, places[i - 1], b)
    const isNew = x !== undefined && !kinks.some((kink) => Math.abs(kink - x) < 1e-6 * span)
    if (isNew) kinks.push(x)
  }
  return kinks
}
