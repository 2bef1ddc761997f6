// Where a warp brings a point from: Newton's method with the exact deformation gradient, in double.
export type Triple = [number, number, number]

/** What the warp makes of a point, and the columns of M = I + J there. */
export interface Moved {
  position: Triple
  columns: [Triple, Triple, Triple]
}

const minus = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
const along = (a: Triple, t: number, b: Triple): Triple => [
  a[0] + t * b[0],
  a[1] + t * b[1],
  a[2] + t * b[2],
]
const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const distance = (a: Triple, b: Triple) => Math.hypot(...minus(a, b))
const isFinite3 = (a: Triple) => a.every(Number.isFinite)

const determinantOf = ([a, b, c]: Moved['columns']) => dot(a, cross(b, c))

/** The solution of M x = r by Cramer's rule; not finite where M is singular. */
function solved([a, b, c]: Moved['columns'], r: Triple): Triple {
  const determinant = dot(a, cross(b, c))
  return [
    dot(r, cross(b, c)) / determinant,
    dot(a, cross(r, c)) / determinant,
    dot(a, cross(b, r)) / determinant,
  ]
}

const mostSteps = 30
/** A step is halved so often. */
const mostHalvings = 8
/** Into so many pieces the way to the point is cut at most. */
const mostPieces = 16
/** After so many evaluations a search gives up: some milliseconds for a small warp. */
const mostEvaluations = 1000
/** A share of the numbers' size: what doubles leave of a warp of some hundred operations. */
const precision = 1e-14
/** The same, of what counts as reached where rounding or a fold stops the way. */
const reached = 1e-9

/** What is known of a place. */
interface Place {
  from: Triple
  to: Moved
}

/** Searches where `warp` brings `target` from. */
class InverseSearch {
  private evaluations = 0

  constructor(
    private readonly warp: (from: Triple) => Moved,
    private readonly target: Triple,
  ) {}

  get isOver() {
    return this.evaluations >= mostEvaluations
  }

  /** The place that the way from `start` leads to; nothing if it ends before. */
  from(start: Triple): Place | undefined {
    let place = this.place(start)
    if (!isFinite3(place.to.position)) return undefined
    // Newton's method alone, and where it fails, the way in pieces: half of what is left, then the rest.
    for (let pieces = 0, share = 1; pieces < mostPieces && !this.isOver; pieces++) {
      const goal = along(place.to.position, share, minus(this.target, place.to.position))
      const next = this.near(place, goal)
      if (next && share === 1) return next
      if (next) place = next
      share = next ? Math.min(1, 2 * share) : share / 2
    }
    return undefined
  }

  /** Newton's method, damped: each step is halved until it leads closer to the goal. */
  private near(start: Place, goal: Triple): Place | undefined {
    let place = start
    let left = distance(place.to.position, goal)
    for (let steps = 0; steps < mostSteps && !this.isOver; steps++) {
      const size = Math.hypot(...place.from) + Math.hypot(...goal)
      if (left <= precision * size) return place
      const step = solved(place.to.columns, minus(goal, place.to.position))
      if (!isFinite3(step)) return undefined
      let next: Place | undefined
      let rest = Infinity
      for (let t = 1; t >= 2 ** -mostHalvings && !(rest < left); t /= 2) {
        next = this.place(along(place.from, t, step))
        rest = distance(next.to.position, goal)
      }
      // What no step makes smaller is rounding, or a fold.
      if (!(rest < left)) return left <= reached * size ? place : undefined
      place = next!
      left = rest
    }
    return undefined
  }

  private place(from: Triple): Place {
    this.evaluations++
    return { from, to: this.warp(from) }
  }
}

/** Towards the 26 cells around one. */
const around = [-1, 0, 1]
  .flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z): Triple => [x, y, z])))
  .filter((direction) => direction.some(Boolean))

/** Where else to start: what comes to the target lies as far from it as the offset there is long. */
function* startsAround(warp: (from: Triple) => Moved, target: Triple, near: Triple) {
  const offset = (at: Triple) => distance(warp(at).position, at)
  let reach = offset(near) || distance(target, near) || 1
  for (let tries = 0; tries < 6; tries++) {
    const longest = Math.max(...around.map((way) => offset(along(target, reach, way))))
    if (!(longest > reach && longest < Infinity)) break
    reach = longest
  }
  for (const share of [1, 0.5]) for (const way of around) yield along(target, share * reach, way)
}

/** The place that the way from `near` leads to, or else another one. */
export function inverse(warp: (from: Triple) => Moved, target: Triple, near: Triple) {
  const search = new InverseSearch(warp, target)
  let found = search.from(near)
  if (!found)
    for (const start of startsAround(warp, target, near))
      if (search.isOver || (found = search.from(start))) break
  return found && { position: [...found.from], isFolded: !(determinantOf(found.to.columns) > 0) }
}
