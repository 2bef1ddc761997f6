/** What many times come to. A value that is not finite is one that could not be measured, and counts for nothing. */

/** The value with `part` of all values below it, between two of them if need be. */
export const middle = (values, part = 0.5) => {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b)
  if (!sorted.length) return NaN
  const place = part * (sorted.length - 1)
  const [below, above] = [sorted[Math.floor(place)], sorted[Math.ceil(place)]]
  return below + (place % 1) * (above - below)
}

/** Half of the values lie between `low` and `high`. */
export const summary = (values) => ({
  median: middle(values),
  low: middle(values, 0.25),
  high: middle(values, 0.75),
})

/** Within each round, so that whatever slowed the round cancels. */
export const ratio = (values, others = []) =>
  middle(others.map((other, round) => values[round] / other))

export const shuffled = (list) => {
  const result = [...list]
  for (let i = result.length - 1; i > 0; i--) {
    const j = Math.floor(Math.random() * (i + 1))
    ;[result[i], result[j]] = [result[j], result[i]]
  }
  return result
}
