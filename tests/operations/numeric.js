// Computes derivatives of plain functions of numbers from finite differences in double precision. The method is that of
// tests/support/browser/oracle.js, but for any number of arguments and results, and with adaptive steps: near a kink, steps are shorter.

/** Step sizes from 1/128 to 2e-7. Longer steps lose less to rounding, shorter ones come closer to a kink. */
const steps = [7, 10, 13, 16, 19, 22].map((power) => 2 ** -power)

/** We try no shorter step once the estimated error is below this. */
const sufficientError = 1e-10

/** A slope with a larger error than this has a kink or a jump within the shortest step. */
const maxError = 1e-7

/** A kink changes the slope by more than this. Like `maxError`, the bound is relative to slopes above 1. */
const minKink = 1e-5

/** Returns `point` moved by `step` along `direction`. */
const movePoint = (point, direction, step) => point.map((x, k) => x + step * direction[k])

/**
 * Returns the slope of each result of `f` at `point` along `direction`, { slope, error }, from one step h. The error is relative
 * to slopes above 1, and infinite at a kink. `middle` is f(point).
 */
function slopesByStep(f, point, direction, h, middle) {
  const at = (step) => f(movePoint(point, direction, step))
  const [after1, before1] = [at(h), at(-h)]
  const [after2, before2] = [at(h / 2), at(-h / 2)]
  const [after4, before4] = [at(h / 4), at(-h / 4)]
  return middle.map((value, i) => {
    // Central differences are f' + a h² + b h⁴ + …; Richardson's extrapolation eliminates a, and then b.
    const d1 = (after1[i] - before1[i]) / (2 * h)
    const d2 = (after2[i] - before2[i]) / h
    const d4 = (after4[i] - before4[i]) / (h / 2)
    const coarse = (4 * d2 - d1) / 3
    const fine = (4 * d4 - d2) / 3
    // Second differences are h f'' + O(h³). Only these show a kink or a jump at the point itself.
    const bend1 = (after1[i] - 2 * value + before1[i]) / h
    const bend2 = (after2[i] - 2 * value + before2[i]) / (h / 2)
    const slope = (16 * fine - coarse) / 15
    const scale = Math.max(1, Math.abs(slope))
    const rounding = (Math.abs(value) * 2 ** -51) / h
    const smooth = Math.abs(bend1 - 2 * bend2) <= minKink * scale
    return { slope, error: smooth ? (Math.abs(fine - coarse) + rounding) / scale : Infinity }
  })
}

/** Returns the slope with the min error of all steps; null for a result that has a kink at the point. */
function slopes(f, point, direction, middle) {
  let best = middle.map(() => ({ error: Infinity }))
  for (const h of steps) {
    if (best.every(({ error }) => error <= sufficientError)) break
    const results = slopesByStep(f, point, direction, h, middle)
    best = best.map((slope, i) => (results[i].error < slope.error ? results[i] : slope))
  }
  return best.map((slope) => (slope.error <= maxError ? slope : null))
}

/**
 * Returns the partial derivatives of `f`, which maps a list of numbers to a list, at `point`: one row for each number of the
 * point, with one { slope, error } for each result, or null if the result has a kink or a jump.
 */
export function jacobian(f, point) {
  const middle = f(point)
  const rows = point.map((_, k) => {
    const direction = point.map((_, j) => (j === k ? 1 : 0))
    return slopes(f, point, direction, middle)
  })
  // The oblique direction finds kinks that the axes miss, such as the jump of sign(x) y at the origin.
  const oblique = point.map((_, k) => (k % 2 ? -1 : 1) * (1 + k / 10))
  const smooth = slopes(f, point, oblique, middle)
  return rows.map((row) => row.map((slope, i) => smooth[i] && slope))
}
