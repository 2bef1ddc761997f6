/** Places the labels of a plot so that none overlap. All lengths are pixels. */

/**
 * Moves labels on a line apart by as little as possible: the least-squares solution in which neighbours keep `gap`
 * (isotonic regression by pooling adjacent violators). @param wanted positions in any order @returns positions in the same order
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

  const max = high - (wanted.length - 1) * gap
  const means = pools.flatMap(({ sum, count }) => Array(count).fill(sum / count))
  const places = []
  order.forEach((index, i) => {
    places[index] = Math.max(low, Math.min(max, means[i])) + i * gap
  })
  return places
}

const doOverlap = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom

const boxAround = (x, y, width, height) => ({
  left: x - width / 2,
  right: x + width / 2,
  top: y - height / 2,
  bottom: y + height / 2,
})

/** The space around a dot, and the gap between it and its label. */
const DOT = 16
const GAP = 11
/** In order of preference: beside the dot, above or below it, then diagonal. */
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
 * Puts each label, in order, at the nearest free place around its dot.
 * @param labels [{ x, y, width, height }]: the dot's position and the text's size
 * @param frame { left, right, top, bottom }
 * @returns [{ x, y, isFar }]: the centers of the texts; `isFar` labels need a line to their dot
 */
export function placeBeside(labels, frame) {
  const taken = labels.map(({ x, y }) => boxAround(x, y, DOT, DOT))
  return labels.map(({ x, y, width, height }) => {
    const candidates = distances.flatMap((distance) =>
      directions.map(([right, down]) => ({
        x: x + right * (width / 2 + GAP + (down ? distance - width / 4 : distance)),
        y: y + down * (height / 2 + GAP / 2 + distance),
        isFar: distance > 0,
      })),
    )
    const isFree = (place) => {
      const box = boxAround(place.x, place.y, width, height)
      const isInside =
        box.left >= frame.left &&
        box.right <= frame.right &&
        box.top >= frame.top &&
        box.bottom <= frame.bottom
      return isInside && !taken.some((other) => doOverlap(box, other))
    }
    const place = candidates.find(isFree) ?? candidates[0]
    taken.push(boxAround(place.x, place.y, width, height))
    return place
  })
}
