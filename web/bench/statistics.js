/** Statistics of measured times. A value that is not finite could not be measured and is ignored. */

/** Returns the quantile at `fraction` (default: the median), interpolated linearly between two values. */
export const quantile = (values, fraction = 0.5) => {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b)
  if (!sorted.length) return NaN
  const place = fraction * (sorted.length - 1)
  const [below, above] = [sorted[Math.floor(place)], sorted[Math.ceil(place)]]
  return below + (place % 1) * (above - below)
}

/** Returns the median and the quartiles: half of the values are between `low` and `high`. */
export const summarize = (values) => ({
  median: quantile(values),
  low: quantile(values, 0.25),
  high: quantile(values, 0.75),
})

/** Returns the median of the ratios of values to references, each within one round, so that whatever slowed a round cancels. */
export const medianRatio = (values, references = []) =>
  quantile(references.map((reference, round) => values[round] / reference))

/** Returns a copy in random order (Fisher-Yates). */
export const shuffle = (list) => {
  const result = [...list]
  for (let i = result.length - 1; i > 0; i--) {
    const j = Math.floor(Math.random() * (i + 1))
    ;[result[i], result[j]] = [result[j], result[i]]
  }
  return result
}
