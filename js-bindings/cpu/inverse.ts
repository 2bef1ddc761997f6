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
/** Maximum evaluations from `near`, and from each other start: many short searches find more than a few long ones. */
const maxFromNear = 500
const maxFromElsewhere = 40
/** Relative rounding error of a warp of a few hundred operations in double. */
const precision = 1e-14
/** Tolerance relative to the size of the goal, for a search that rounding or a fold stops. */
const reached = 1e-9
/** Maximum size of a place in the rounding tolerance: without it, any goal would count as reached from far away. */
const roundingSize = 1e4

const sizeOf = (a: Triple) => Math.hypot(...a)

/** What is known of a place. */
interface Place {
  from: Triple
  to: Moved
}

/** The accepted distance from `goal`: a share of the goal's size plus the rounding error. */
const tolerance = (share: number, { from }: Place, goal: Triple) =>
  share * sizeOf(goal) + precision * Math.min(sizeOf(from), roundingSize)

/** Searches where `warp` brings `target` from. */
class InverseSearch {
  private evaluations = 0
  private limit = maxFromNear

  constructor(
    private readonly warp: (from: Triple) => Moved,
    private readonly target: Triple,
  ) {}

  get isOver() {
    return this.evaluations >= mostEvaluations
  }

  private get isAtLimit() {
    return this.evaluations >= this.limit
  }

  /** Like `from`, but limited to `maxFromElsewhere` evaluations. */
  fromElsewhere(start: Triple): Place | undefined {
    this.limit = this.evaluations + maxFromElsewhere
    return this.from(start)
  }

  /** The place that the way from `start` leads to; nothing if it ends before. */
  from(start: Triple): Place | undefined {
    let place = this.place(start)
    if (!isFinite3(place.to.position)) return undefined
    // Newton's method alone, and where it fails, the way in pieces: half of what is left, then the rest.
    for (let pieces = 0, share = 1; pieces < mostPieces && !this.isAtLimit; pieces++) {
      const { position } = place.to
      // The target itself: the sum would have lost it to rounding where the warp leads far away.
      const goal = share === 1 ? this.target : along(position, share, minus(this.target, position))
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
    for (let steps = 0; steps < mostSteps && !this.isAtLimit; steps++) {
      if (left <= tolerance(precision, place, goal)) return place
      const step = solved(place.to.columns, minus(goal, place.to.position))
      if (!isFinite3(step)) return undefined
      let next: Place | undefined
      let rest = Infinity
      for (let t = 1; t >= 2 ** -mostHalvings && !(rest < left); t /= 2) {
        next = this.place(along(place.from, t, step))
        rest = distance(next.to.position, goal)
      }
      // What no step makes smaller is rounding, or a fold.
      if (!(rest < left)) return left <= tolerance(reached, place, goal) ? place : undefined
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

/** Further starts. A place that the warp moves to the target is mostly about one offset length away from it. */
function* startsAround(warp: (from: Triple) => Moved, target: Triple, near: Triple) {
  const offset = distance(warp(target).position, target)
  const reach = (Number.isFinite(offset) && offset) || distance(target, near) || 1
  if (distance(target, near) > 0) yield target
  for (const share of [1, 0.5, 0.25, 2])
    for (const way of around) yield along(target, share * reach, way)
}

/** Finds the place that the search from `near` leads to, or else another one. The warp moves it to the target, within the tolerance above. */
export function inverse(warp: (from: Triple) => Moved, target: Triple, near: Triple) {
  const search = new InverseSearch(warp, target)
  let found = search.from(near)
  if (!found)
    for (const start of startsAround(warp, target, near))
      if (search.isOver || (found = search.fromElsewhere(start))) break
  return found && { position: [...found.from], isFolded: !(determinantOf(found.to.columns) > 0) }
}
