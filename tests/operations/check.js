// Checks whether the results of a case, on any pipeline, are within the tolerances: returns descriptions of the problems.
import { errorOf, measure } from './measure.js'

/** Tolerances on the CPU: double precision for values, and the precision of finite differences for derivatives. */
export const inDouble = {
  value: 1e-12,
  derivative: 1e-9,
  because: 'double precision, and differences are good to 1e-10',
}

const describe = (kind, { error, at, got, expected, by }, allowed) =>
  `${kind}${by === undefined ? '' : ` by number ${by} of the operands`} is ${got} at ` +
  `(${at.join(', ')}), expected ${expected}: ${error.toExponential(1)} off, ${allowed} allowed`

/** Measures a case of the reference; returns descriptions of the problems. See `measure` for `run`. */
export async function problemsOf(operation, run, tolerance = operation.tolerance) {
  const measured = await measure(operation, run)
  const problems = ['value', 'derivative']
    .filter((kind) => !(measured[kind].error <= tolerance[kind]))
    .map((kind) => describe(kind, measured[kind], tolerance[kind]))
  if (measured.fewest < 200)
    problems.push(
      `expected 200 points at which each derivative is compared, got ${measured.fewest}`,
    )
  if (measured.excluded && !operation.kinks)
    problems.push(`expected no kinks, as in the reference, got ${measured.excluded}`)
  return problems.map((problem) => `${operation.title}: ${problem}`)
}

/** Compares the results of a case with its conventions; returns descriptions of the problems. */
export async function brokenConventions(
  { operation, points },
  run,
  tolerance = operation.tolerance,
) {
  const results = await run(points.map(({ at }) => at))
  return points.flatMap(({ at, value, slopes }, i) =>
    [...value, ...slopes].flatMap((expected, k) => {
      const kind = k < value.length ? 'value' : 'derivative'
      const [got, error] = [results[i][k], errorOf(results[i][k], expected, 1)]
      const by = k < value.length ? undefined : Math.floor(k / value.length) - 1
      const measured = { error, at, got, expected, by }
      if (error <= tolerance[kind]) return []
      return [`${operation.title}: ${describe(kind, measured, tolerance[kind])}`]
    }),
  )
}
