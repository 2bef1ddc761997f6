// Computes derivatives of a function of numbers from finite differences, with Richardson extrapolation from three step sizes, and checks
// whether the function is smooth enough for that.

const firstDerivativeStep = 2 ** -12
const secondDerivativeStep = 2 ** -8

/** Returns a point with some components shifted; each shift is [component, amount]. */
function movePoint(point, ...shifts) {
  const result = { ...point }
  for (const [{ name, index }, shift] of shifts) {
    result[name] = [...result[name]]
    result[name][index] += shift
  }
  return result
}

/** Uses differences of steps h, h/2 and h/4, whose errors are a h² + b h⁴ + … */
function extrapolate([d1, d2, d3]) {
  const [coarse, fine] = [(4 * d2 - d1) / 3, (4 * d3 - d2) / 3]
  return { value: (16 * fine - coarse) / 15, error: Math.abs(coarse - fine) }
}

/** Returns [{ value, error }]: ∂f/∂by for each component of f. A kink or a jump nearby makes the error large. */
function firstDerivative(f, point, by, valueAtPoint) {
  const steps = [1, 2, 4].map((part) => firstDerivativeStep / part)
  const pairs = steps.map((step) => [
    f(movePoint(point, [by, step])),
    f(movePoint(point, [by, -step])),
  ])
  return valueAtPoint.map((_, i) => {
    const slopes = pairs.map(([after, before], s) => (after[i] - before[i]) / (2 * steps[s]))
    const estimate = extrapolate(slopes)
    // Second differences are h f'' + O(h³). Only these show a kink at the point itself.
    const [bend, halfBend] = pairs.map(
      ([after, before], s) => (after[i] - 2 * valueAtPoint[i] + before[i]) / steps[s],
    )
    return { ...estimate, error: estimate.error + Math.abs(bend - 2 * halfBend) }
  })
}

/** Returns the points that a second difference of step h uses. */
function corners(point, first, second, step) {
  const shifts = isSame(first, second)
    ? [1, -1].map((i) => [[first, i * step]])
    : [1, 1, -1, -1].map((i, k) => [
        [first, i * step],
        [second, (k % 2 ? -1 : 1) * step],
      ])
  return shifts.map((shift) => movePoint(point, ...shift))
}
const isSame = (a, b) => a.name === b.name && a.index === b.index

/** Returns [{ value, error }]: ∂²f/∂first ∂second for each component of f. */
function secondDerivative(f, point, first, second, valueAtPoint) {
  const steps = [1, 2, 4].map((part) => secondDerivativeStep / part)
  const differences = steps.map((step) => {
    const [a, b, c, d] = corners(point, first, second, step).map(f)
    return valueAtPoint.map((value, i) =>
      isSame(first, second)
        ? (a[i] - 2 * value + b[i]) / step ** 2
        : (a[i] - b[i] - c[i] + d[i]) / (4 * step ** 2),
    )
  })
  return valueAtPoint.map((_, i) => extrapolate(differences.map((difference) => difference[i])))
}

/** Returns the outermost points of the differences for the derivative with respect to one or two components. */
export const outermost = (point, [first, second]) =>
  second
    ? corners(point, first, second, secondDerivativeStep)
    : corners(point, first, first, firstDerivativeStep)

/** Returns [{ value, error }]: the derivative of each component of f with respect to one or two components; `valueAtPoint` is f(point). */
export const derivative = (f, point, [first, second], valueAtPoint) =>
  second
    ? secondDerivative(f, point, first, second, valueAtPoint)
    : firstDerivative(f, point, first, valueAtPoint)

/** Estimates the derivative with respect to one or two components from a single step, to a few digits. */
export function slopeOf(f, point, [first, second]) {
  const slope = (g, by, step) => (at) => {
    const [after, before] = [g(movePoint(at, [by, step])), g(movePoint(at, [by, -step]))]
    return after.map((value, i) => (value - before[i]) / (2 * step))
  }
  if (!second) return slope(f, first, firstDerivativeStep)(point)
  return slope(slope(f, first, secondDerivativeStep), second, secondDerivativeStep)(point)
}
