// Finds a position that a warp moves to a point: Newton's method with the exact deformation gradient, in double precision.
export type Triple = [number, number, number]

/** The warped position of a point, and the columns of M = I + J there. */
export interface Warped {
  position: Triple
  columns: [Triple, Triple, Triple]
}

type Warp = (from: Triple) => Warped

const minus = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
/** Returns a + t b. */
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

const determinantOf = ([a, b, c]: Warped['columns']) => dot(a, cross(b, c))

/** Solves M x = r by Cramer's rule; not finite where M is singular. */
function solve3x3([a, b, c]: Warped['columns'], r: Triple): Triple {
  const determinant = dot(a, cross(b, c))
  return [
    dot(r, cross(b, c)) / determinant,
    dot(a, cross(r, c)) / determinant,
    dot(a, cross(b, r)) / determinant,
  ]
}

const maxSteps = 30
/** Maximum times that a step is halved. */
const maxHalvings = 8
/** Maximum intermediate goals on the way to the target. */
const maxGoals = 16
/** Maximum evaluations of a whole search: some milliseconds for a small warp. */
const maxEvaluations = 1000
/** Maximum evaluations from `near`, and from each other start: many short searches find more than a few long ones. */
const maxFromNear = 500
const maxFromElsewhere = 40
/** Relative rounding error of a warp of a few hundred operations in double. */
const precision = 1e-14
/** Tolerance relative to the size of the goal, for a search that rounding or a fold stops. */
const relativeTolerance = 1e-9
/** Caps the position's size in the rounding tolerance; otherwise a position far away would be accepted for any goal. */
const maxRoundingSize = 1e4

const sizeOf = (a: Triple) => Math.hypot(...a)

/** An evaluation of the warp. */
interface Sample {
  from: Triple
  to: Warped
}

/** Returns the accepted distance from `goal`: a share of the goal's size plus the rounding error. */
const tolerance = (share: number, { from }: Sample, goal: Triple) =>
  share * sizeOf(goal) + precision * Math.min(sizeOf(from), maxRoundingSize)

/** Searches for positions that `warp` moves to `target`. */
class InverseSearch {
  private evaluations = 0
  private limit = maxFromNear

  constructor(
    private readonly warp: Warp,
    private readonly target: Triple,
  ) {}

  get isOver() {
    return this.evaluations >= maxEvaluations
  }

  private get isAtLimit() {
    return this.evaluations >= this.limit
  }

  /** Searches like `searchFrom`, but with at most `maxFromElsewhere` evaluations. */
  searchFromElsewhere(start: Triple): Sample | undefined {
    this.limit = this.evaluations + maxFromElsewhere
    return this.searchFrom(start)
  }

  /** Searches from `start`; returns `undefined` if that fails. */
  searchFrom(start: Triple): Sample | undefined {
    let sample = this.sample(start)
    if (!isFinite3(sample.to.position)) return undefined
    // The first goal is the target itself. Where Newton's method fails, the next goal is half as far; after a success, twice as far.
    for (let goals = 0, share = 1; goals < maxGoals && !this.isAtLimit; goals++) {
      const { position } = sample.to
      // For a share of 1, the sum would have a large rounding error if the warp moves points far away.
      const goal = share === 1 ? this.target : along(position, share, minus(this.target, position))
      const next = this.dampedNewton(sample, goal)
      if (next && share === 1) return next
      if (next) sample = next
      share = next ? Math.min(1, 2 * share) : share / 2
    }
    return undefined
  }

  /** Runs Newton's method, damped: each step is halved until it gets closer to the goal. */
  private dampedNewton(start: Sample, goal: Triple): Sample | undefined {
    let sample = start
    let distanceLeft = distance(sample.to.position, goal)
    for (let steps = 0; steps < maxSteps && !this.isAtLimit; steps++) {
      if (distanceLeft <= tolerance(precision, sample, goal)) return sample
      const step = solve3x3(sample.to.columns, minus(goal, sample.to.position))
      if (!isFinite3(step)) return undefined
      let next: Sample | undefined
      let nextDistance = Infinity
      for (let t = 1; t >= 2 ** -maxHalvings && !(nextDistance < distanceLeft); t /= 2) {
        next = this.sample(along(sample.from, t, step))
        nextDistance = distance(next.to.position, goal)
      }
      // A distance that no step reduces is due to rounding, or to a fold.
      if (!(nextDistance < distanceLeft))
        return distanceLeft <= tolerance(relativeTolerance, sample, goal) ? sample : undefined
      sample = next!
      distanceLeft = nextDistance
    }
    return undefined
  }

  private sample(from: Triple): Sample {
    this.evaluations++
    return { from, to: this.warp(from) }
  }
}

/** Directions to the 26 neighbours of a grid cell. */
const neighbours = [-1, 0, 1]
  .flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z): Triple => [x, y, z])))
  .filter((direction) => direction.some(Boolean))

/** Yields further starts. A position that the warp moves to the target is mostly about one offset length away from it. */
function* startsAround(warp: Warp, target: Triple, near: Triple) {
  const offset = distance(warp(target).position, target)
  const reach = (Number.isFinite(offset) && offset) || distance(target, near) || 1
  if (distance(target, near) > 0) yield target
  for (const share of [1, 0.5, 0.25, 2])
    for (const direction of neighbours) yield along(target, share * reach, direction)
}

/**
 * Finds a position that the warp moves to the target, within the tolerance above: the one that the search from `near` reaches, or else
 * another.
 */
export function findInverse(warp: Warp, target: Triple, near: Triple) {
  const search = new InverseSearch(warp, target)
  let found = search.searchFrom(near)
  if (!found)
    for (const start of startsAround(warp, target, near))
      if (search.isOver || (found = search.searchFromElsewhere(start))) break
  return found && { position: [...found.from], isFolded: !(determinantOf(found.to.columns) > 0) }
}
