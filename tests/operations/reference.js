// The operations to test: every row of tests/operations/reference with every list of operand shapes is a case.
import { arithmetic } from './reference/arithmetic.js'
import { calculus } from './reference/calculus.js'
import { conditions } from './reference/conditions.js'
import { functions } from './reference/functions.js'
import { matrices } from './reference/matrices.js'
import { widest } from './reference/row.js'
import { scalars } from './reference/scalars.js'
import { rounding } from './reference/tolerances.js'
import { vectors } from './reference/vectors.js'

export const rows = [
  ...scalars,
  ...arithmetic,
  ...conditions,
  ...vectors,
  ...matrices,
  ...calculus,
  ...functions,
]

const shapeName = (shape) =>
  shape === 1 ? 'float' : typeof shape === 'number' ? `vec${shape}` : shape

/**
 * The cases, [{ title, name, group, inputs, result, domains, adjust, reference, build, kinks, tolerance, sensitivity, only,
 * inShaders }]. `inputs` are { name, shape }, `result` is a shape; the other members are those of the row, see
 * tests/operations/reference/scalars.js.
 */
export const cases = rows.flatMap((row) =>
  row.shapes.map((shapes) => ({
    group: row.name,
    tolerance: rounding,
    adjust: (operands) => operands,
    build: ({ call }, ...operands) => call(...operands),
    sensitivity: {},
    ...row,
    title: `${row.name}(${shapes.map(shapeName).join(', ')})${row.note ? `: ${row.note}` : ''}`,
    inputs: shapes.map((shape, i) => ({ name: `a${i}`, shape })),
    result: (row.result ?? widest)(shapes),
  })),
)
