/**
 * Welding and Loop's subdivision, on lists: `points` [[x, y, z], …] and `triangles` [[a, b, c], …].
 * One step splits each triangle into four and rounds the shape. Source: Loop 1987, with Warren's
 * simpler weights and the cubic B-spline rule along open borders (Hoppe et al. 1994).
 */

/**
 * Merges points at the same position if two triangles share an edge there. A single shared point is
 * not enough: the teapot's handle touches the body in one point and would be pinched to it.
 */
export function weld(points, triangles) {
  const same = points.map((_, i) => i)
  const root = (i) => {
    while (same[i] !== i) i = same[i]
    return i
  }
  const place = points.map((p) => p.map((x) => x.toFixed(4)).join())
  const seen = new Map()
  for (const triangle of triangles) {
    triangle.forEach((a, k) => {
      const b = triangle[(k + 1) % 3]
      const [first, last] = place[a] < place[b] ? [a, b] : [b, a]
      const key = `${place[first]} ${place[last]}`
      if (!seen.has(key)) return seen.set(key, [first, last])
      const [otherFirst, otherLast] = seen.get(key)
      same[root(first)] = root(otherFirst)
      same[root(last)] = root(otherLast)
    })
  }
  const roots = points.map((_, i) => i).filter((i) => same[i] === i)
  const newIndices = new Map(roots.map((i, newIndex) => [i, newIndex]))
  return {
    points: roots.map((i) => points[i]),
    triangles: triangles.map((triangle) => triangle.map((i) => newIndices.get(root(i)))),
  }
}

const weightedSum = (...terms) => {
  const sum = [0, 0, 0]
  for (const [weight, p] of terms) for (let k = 0; k < 3; k++) sum[k] += weight * p[k]
  return sum
}

/** Warren's weight of one of n neighbours; n = 2 is a point on an open border. */
const beta = (n) => (n === 2 ? 1 / 8 : n === 3 ? 3 / 16 : 3 / (8 * n))

const edgeKey = (a, b) => (a < b ? `${a},${b}` : `${b},${a}`)

/** Maps each edge to its two ends and the one or two corners opposite to it. */
function edgesOf(triangles) {
  const edges = new Map()
  for (const triangle of triangles) {
    triangle.forEach((a, k) => {
      const [b, c] = [triangle[(k + 1) % 3], triangle[(k + 2) % 3]]
      const key = edgeKey(a, b)
      if (!edges.has(key)) edges.set(key, { ends: [a, b], opposite: [] })
      edges.get(key).opposite.push(c)
    })
  }
  return edges
}

/** Returns the neighbours of each point; for a point on an open border, only those along the border. */
function listNeighbours(points, edges) {
  const all = points.map(() => [])
  const border = points.map(() => [])
  for (const { ends, opposite } of edges.values()) {
    for (const lists of opposite.length === 2 ? [all] : [all, border]) {
      lists[ends[0]].push(ends[1])
      lists[ends[1]].push(ends[0])
    }
  }
  return all.map((list, i) => (border[i].length > 0 ? border[i] : list))
}

/**
 * Moves each point towards its neighbours `around`; `weightOf(n)` is the weight of one of n neighbours.
 */
const pullPoints = (points, around, weightOf) =>
  points.map((p, i) => {
    const pull = weightOf(around[i].length)
    const terms = around[i].map((j) => [pull, points[j]])
    return weightedSum([1 - around[i].length * pull, p], ...terms)
  })

export function subdivide({ points, triangles }) {
  const edges = edgesOf(triangles)
  const middle = new Map()
  const added = []
  for (const [key, { ends, opposite }] of edges) {
    const [a, b] = ends.map((i) => points[i])
    const [c, d] = opposite.map((i) => points[i])
    middle.set(key, points.length + added.length)
    added.push(
      d
        ? weightedSum([3 / 8, a], [3 / 8, b], [1 / 8, c], [1 / 8, d])
        : weightedSum([1 / 2, a], [1 / 2, b]),
    )
  }
  const between = (a, b) => middle.get(edgeKey(a, b))
  return {
    points: [...pullPoints(points, listNeighbours(points, edges), beta), ...added],
    triangles: triangles.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)]
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ]
    }),
  }
}

/**
 * Moves the points of a mesh so that its limit surface passes through the original points and thin parts keep
 * their thickness. A point p with n neighbours q has the limit (1 - nγ) p + γ Σ q, γ = 1 / (3 / (8β)
 * + n). The points are moved by the remaining error three times (Jacobi iteration): more would gain
 * little and begin to ripple.
 */
export function interpolatePoints({ points, triangles }) {
  const around = listNeighbours(points, edgesOf(triangles))
  const gamma = (n) => (n === 2 ? 1 / 6 : 1 / (3 / (8 * beta(n)) + n))
  let control = points
  for (let i = 0; i < 3; i++) {
    const limits = pullPoints(control, around, gamma)
    control = control.map((p, j) => weightedSum([1, p], [1, points[j]], [-1, limits[j]]))
  }
  return { points: control, triangles }
}
