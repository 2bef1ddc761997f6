// Comparisons, logic and selection. A comparison of vectors works by component. scalars.js describes rows.
import { binary, makeOperandsMeet, span } from './row.js'

const number = span(-2, 2, { at: [0, 1] })
const toNumber = (condition) => (condition ? 1 : 0)
const conditionShape = (shapes) => {
  const size = Math.max(...shapes)
  return size === 1 ? 'bool' : `bvec${size}`
}

const comparison = (name, holds) => ({
  name,
  shapes: binary,
  result: conditionShape,
  domains: [number],
  adjust: makeOperandsMeet,
  kinks: 'where the operands are equal',
  reference: (a, b) =>
    Array.from({ length: Math.max(a.length, b.length) }, (_, i) =>
      toNumber(holds(a[i % a.length], b[i % b.length])),
    ),
})

/** Makes a row for a logical operation, on the conditions that the operands are above zero. */
const logic = (name, counts, holds) => ({
  name,
  note: 'of conditions, operands above 0',
  shapes: counts.flatMap((count) => [1, 3].map((size) => Array(count).fill(size))),
  result: conditionShape,
  domains: [number],
  kinks: 'at 0',
  build: ({ call }, ...operands) => call(...operands.map((operand) => operand.gt(0))),
  reference: (...operands) =>
    operands[0].map((_, i) => toNumber(holds(...operands.map((operand) => operand[i] > 0)))),
})

const choice = (name, shapes) => ({
  name,
  note: 'first operand above 0',
  shapes,
  domains: [number, span(-3, 3)],
  kinks: 'where the condition changes',
  build: ({ call }, condition, yes, no) => call(condition.gt(0), yes, no),
  reference: (condition, yes, no) =>
    Array.from({ length: Math.max(condition.length, yes.length, no.length) }, (_, i) => {
      const selected = condition[i % condition.length] > 0 ? yes : no
      return selected[i % selected.length]
    }),
})

export const conditions = [
  comparison('lt', (a, b) => a < b),
  comparison('le', (a, b) => a <= b),
  comparison('gt', (a, b) => a > b),
  comparison('ge', (a, b) => a >= b),
  comparison('eq', (a, b) => a === b),
  comparison('ne', (a, b) => a !== b),
  logic('and', [2, 3], (...values) => values.every(Boolean)),
  logic('or', [2, 3], (...values) => values.some(Boolean)),
  logic('not', [1], (value) => !value),
  choice('ifElse', [
    [1, 1, 1],
    [1, 3, 3],
    [3, 3, 3],
    [1, 4, 1],
    [2, 1, 2],
  ]),
  choice('vecIfElse', [
    [1, 2, 2],
    [1, 3, 3],
    [4, 4, 4],
  ]),
]
