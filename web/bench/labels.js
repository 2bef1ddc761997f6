/** Where the words of a plot go so that none covers another. All lengths are pixels. */

/**
 * Moves the places of labels on a line apart, as little as can be: the least squares under which neighbours keep `gap`
 * (isotonic regression, by pooling adjacent violators). @param wanted in any order @returns places in the same order
 */
export function spread(wanted, gap, [low, high]) {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b])
  const pools = []
  order.forEach((index, i) => {
    let pool = { sum: wanted[index] - i * gap, count: 1 }
    while (pools.length && pools.at(-1).sum / pools.at(-1).count > pool.sum / pool.count) {
      const { sum, count } = pools.pop()
      pool = { sum: sum + pool.sum, count: count + pool.count }
    }
    pools.push(pool)
  })

  const most = high - (wanted.length - 1) * gap
  const means = pools.flatMap(({ sum, count }) => Array(count).fill(sum / count))
  const places = []
  order.forEach((index, i) => {
    places[index] = Math.max(low, Math.min(most, means[i])) + i * gap
  })
  return places
}

const overlap = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom

const around = (x, y, width, height) => ({
  left: x - width / 2,
  right: x + width / 2,
  top: y - height / 2,
  bottom: y + height / 2,
})

/** Room around a dot, and between it and its label. */
const DOT = 16
const GAP = 11
/** First beside the dot, then above and below it, then askew. */
const directions = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [1, -1],
  [1, 1],
  [-1, -1],
  [-1, 1],
]
const distances = [0, 10, 20, 32, 46, 62, 80]

/**
 * Each label goes to the nearest free place around its dot, in the order of the labels.
 * @param labels [{ x, y, width, height }], of the dot and of its text
 * @param frame { left, right, top, bottom }
 * @returns [{ x, y, isFar }], the middles of the texts; one that is far from its dot wants a line to it
 */
export function placeBeside(labels, frame) {
  const taken = labels.map(({ x, y }) => around(x, y, DOT, DOT))
  return labels.map(({ x, y, width, height }) => {
    const candidates = distances.flatMap((distance) =>
      directions.map(([right, down]) => ({
        x: x + right * (width / 2 + GAP + (down ? distance - width / 4 : distance)),
        y: y + down * (height / 2 + GAP / 2 + distance),
        isFar: distance > 0,
      })),
    )
    const isFree = (place) => {
      const box = around(place.x, place.y, width, height)
      const isInside =
        box.left >= frame.left &&
        box.right <= frame.right &&
        box.top >= frame.top &&
        box.bottom <= frame.bottom
      return isInside && !taken.some((other) => overlap(box, other))
    }
    const place = candidates.find(isFree) ?? candidates[0]
    taken.push(around(place.x, place.y, width, height))
    return place
  })
}
