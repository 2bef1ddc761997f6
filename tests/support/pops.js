// Measures pops: how far drawn surfaces jump on the screen when a mesh is subdivided again.
import { pixelsOf, samplesOf } from './screen-error.js'

/** Points of a triangle: corners, quarters of the sides, and points inside, as weights of the corners. */
const places = []
for (let i = 0; i <= 4; i++)
  for (let j = 0; i + j <= 4; j++) places.push([1 - (i + j) / 4, i / 4, j / 4])

/**
 * Gives each triangle of a mesh vertices of its own, whose colors are the index of the triangle and the weights of its second and third
 * corner. A division interpolates colors, so that its vertices show at which place of the original mesh they are.
 */
export function markPlaces({ positions, normals, indices }) {
  const count = indices.length
  const gather = (values) =>
    Float32Array.from(
      { length: 3 * count },
      (_, i) => values[3 * indices[Math.floor(i / 3)] + (i % 3)],
    )
  const colors = Array.from({ length: count }, (_, v) => [
    Math.floor(v / 3),
    Number(v % 3 === 1),
    Number(v % 3 === 2),
    1,
  ])
  return { positions: gather(positions), normals: gather(normals), colors: colors.flat() }
}

/** Copies the arrays of a divided mesh, which the next update overwrites. */
export const copyDivision = ({ positions, normals, colors, indices }) => ({
  positions: positions.slice(),
  normals: normals.slice(),
  colors: colors.slice(),
  indices: indices.slice(),
})

/**
 * Finds the triangle of a division that contains a place of the original mesh. Each triangle of the original mesh has a grid, whose cells
 * list the triangles of the division that overlap them.
 */
class Locator {
  constructor({ colors, indices }) {
    this.colors = colors
    this.indices = indices
    const count = indices.length / 3
    const counts = []
    for (let t = 0; t < count; t++) {
      const original = this.originalOf(t)
      counts[original] = (counts[original] ?? 0) + 1
    }
    this.grids = counts.map((each) => {
      const size = Math.ceil(Math.sqrt(each))
      return { size, cells: Array.from({ length: size * size }, () => []) }
    })
    for (let t = 0; t < count; t++) {
      const { size, cells } = this.grids[this.originalOf(t)]
      const [fromX, toX] = this.cellsAlong(t, 1, size)
      const [fromY, toY] = this.cellsAlong(t, 2, size)
      for (let x = fromX; x <= toX; x++)
        for (let y = fromY; y <= toY; y++) cells[x * size + y].push(t)
    }
  }

  originalOf = (t) => Math.round(this.corner(t, 0, 0))
  corner = (t, i, k) => this.colors[4 * this.indices[3 * t + i] + k]

  /** Returns the first and the last cell that a triangle overlaps, or would overlap without rounding. */
  cellsAlong(t, k, size) {
    const all = [this.corner(t, 0, k), this.corner(t, 1, k), this.corner(t, 2, k)]
    return [cellAt(Math.min(...all) - rounding, size), cellAt(Math.max(...all) + rounding, size)]
  }

  /**
   * Returns the triangle at a place, and the weights of its corners. If rounding puts the place outside of all triangles, returns the
   * nearest one.
   */
  find(original, x, y) {
    const { size, cells } = this.grids[original]
    const best = { minWeight: -Infinity, t: -1, weights: [0, 0, 0] }
    for (const t of cells[cellAt(x, size) * size + cellAt(y, size)]) {
      const [ax, ay] = [this.corner(t, 0, 1), this.corner(t, 0, 2)]
      const [ux, uy] = [this.corner(t, 1, 1) - ax, this.corner(t, 1, 2) - ay]
      const [vx, vy] = [this.corner(t, 2, 1) - ax, this.corner(t, 2, 2) - ay]
      const area = ux * vy - vx * uy
      const b = ((x - ax) * vy - vx * (y - ay)) / area
      const c = (ux * (y - ay) - (x - ax) * uy) / area
      const minWeight = Math.min(1 - b - c, b, c)
      if (minWeight > best.minWeight)
        Object.assign(best, { minWeight, t, weights: [1 - b - c, b, c] })
    }
    return best
  }
}

const rounding = 1e-6
const cellAt = (x, size) => Math.min(size - 1, Math.max(0, Math.floor(x * size)))

const locators = new WeakMap()

/** Caches locators, since the division after one change is the division before the next. */
function locatorOf(division) {
  if (!locators.has(division)) locators.set(division, new Locator(division))
  return locators.get(division)
}

/**
 * Returns the distances, in pixels, by which points of the drawn surface jump on the screen between two frames, `before` and `after`:
 * { division, warpPositions, view }, where `warpPositions` and `view` are as for `screenErrors`. A jump is how much a point moves more than
 * the warped surface does at its place of the original mesh. `choose` maps a division to the triangles that are measured; points outside of
 * the picture are left out.
 */
export function popsBetween(before, after, choose = allOf) {
  const [a, b] = [before, after].map((frame) => ({
    ...frame,
    warped: frame.warpPositions(frame.division),
    locator: locatorOf(frame.division),
  }))
  return [...popsAt(a, b, choose(a.division)), ...popsAt(b, a, choose(b.division))]
}

const allOf = ({ indices }) => Array.from({ length: indices.length / 3 }, (_, t) => t)

/** Returns the distances at the points of triangles of the frame `here`, which follows or precedes the frame `there`. */
function popsAt(here, there, triangles) {
  const { division } = here
  const points = triangles.flatMap((t) => places.map((weights) => ({ t, weights })))
  const samples = samplesOf(division, triangles, places)
  const [truthHere, truthThere] = [here, there].map((frame) => frame.warpPositions(samples))
  const pops = []
  points.forEach(({ t, weights }, i) => {
    const original = Math.round(division.colors[4 * division.indices[3 * t]])
    const [x, y] = [1, 2].map((k) => blend(division.colors, 4, k, division.indices, t, weights))
    const found = there.locator.find(original, x, y)
    // A place that no triangle covers would be a defect of its own.
    if (!(found.minWeight > -1e-3)) throw new Error(`no triangle at ${original}, ${x}, ${y}`)
    const errorHere = errorOf(here, t, weights, truthHere, i)
    const errorThere = errorOf(there, found.t, found.weights, truthThere, i)
    if (errorHere && errorThere)
      pops.push(Math.hypot(errorHere[0] - errorThere[0], errorHere[1] - errorThere[1]))
  })
  return pops
}

/** Returns the offset on the screen, in pixels, of the drawn point from warped point `i` of `truth`; `undefined` if one is outside of the picture. */
function errorOf({ division, warped, view }, t, weights, truth, i) {
  const drawn = pixelsOf(vectorOf(warped, division, t, weights), 0, view)
  const place = pixelsOf(truth, 3 * i, view)
  return drawn && place && [drawn[0] - place[0], drawn[1] - place[1]]
}

function blend(values, size, k, indices, t, [a, b, c]) {
  const at = (i) => values[size * indices[3 * t + i] + k]
  return a * at(0) + b * at(1) + c * at(2)
}

const vectorOf = (values, { indices }, t, weights) =>
  [0, 1, 2].map((k) => blend(values, 3, k, indices, t, weights))
