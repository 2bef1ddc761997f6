// Holes in pictures of closed meshes, and how to make one. These functions import nothing, so that tests can put their source into pages.

/**
 * Counts the pixels in holes of a square picture: open pixels that are not connected to the border. Pixels with a common corner are
 * connected, so that notches of an outline are no holes. `isOpen(i)` tests whether pixel i shows something other than the surface.
 */
export function countHoles(size, isOpen) {
  const seen = new Uint8Array(size * size)
  const waiting = []
  const visit = (i) => {
    if (seen[i] || !isOpen(i)) return
    seen[i] = 1
    waiting.push(i)
  }
  for (let k = 0; k < size; k++)
    for (const i of [k, size * (size - 1) + k, size * k, size * k + size - 1]) visit(i)
  while (waiting.length) {
    const i = waiting.pop()
    const [x, y] = [i % size, Math.floor(i / size)]
    for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, size - 1); v++)
      for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, size - 1); u++) visit(v * size + u)
  }
  let holes = 0
  for (let i = 0; i < size * size; i++) if (isOpen(i) && !seen[i]) holes++
  return holes
}

/**
 * Makes a crack, as if an edge had different numbers of pieces in its two triangles: finds a vertex on a straight line of edges, and
 * removes it from the triangles on one side of the line, but not from those on the other side. Tries every seventh vertex from `first` on,
 * and takes the one with the longest line; returns `false` if there is none. Changes `indices`; `positions` has `stride` numbers per
 * vertex.
 */
export function breakEdge(indices, positions, stride, first) {
  /** Maps a vertex → the triangles around it, as [place in indices, next corner, last corner]. */
  const around = new Map()
  for (let at = 0; at < indices.length; at++) {
    const triangle = at - (at % 3)
    const [next, last] = [1, 2].map((k) => indices[triangle + ((at + k) % 3)])
    if (!around.has(indices[at])) around.set(indices[at], [])
    around.get(indices[at]).push([at, next, last])
  }
  const direction = (from, to) =>
    [0, 1, 2].map((k) => positions[stride * to + k] - positions[stride * from + k])
  /** Returns the length of the line from `a` to `b` if `middle` is on this line, else 0. */
  const lengthOf = (middle, a, b) => {
    const [u, v] = [direction(middle, a), direction(middle, b)]
    const dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    const [length, other] = [Math.hypot(...u), Math.hypot(...v)]
    return dot < -0.99999 * length * other ? length + other : 0
  }
  const best = { length: 0, fan: [] }
  const vertices = [...around.keys()]
  for (let i = first % 7; i < vertices.length; i += 7) {
    const byNext = new Map(around.get(vertices[i]).map((each) => [each[1], each]))
    for (const start of byNext.keys()) {
      const fan = []
      for (let each = byNext.get(start); each && fan.length < byNext.size;) {
        fan.push(each)
        const length = fan.length > 1 ? lengthOf(vertices[i], start, each[2]) : 0
        if (length > best.length) Object.assign(best, { length, fan: [...fan] })
        each = byNext.get(each[2])
      }
    }
  }
  if (best.length === 0) return false
  // The triangles on this side are a fan around the vertex. The first one gets the end of the line in place of the vertex, and the others
  // become a fan around the last corner of the first one.
  const { fan } = best
  const corner = fan[1][1]
  indices[fan[0][0]] = fan.at(-1)[2]
  for (const [at] of fan.slice(1)) indices[at] = corner
  return true
}
