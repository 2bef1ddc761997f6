// Finds which pieces of piecewise operations an expression uses at a point. If they are the same at all points around it, the expression is
// smooth there; exactly at a kink, which differences may miss, the slope is a matter of convention.
import { evaluate } from './ast.js'

/** Compares each pair of operands. */
const order = (...operands) =>
  operands.flatMap((x, i) => operands.slice(i + 1).map((y) => Math.sign(x - y)))
/** Finds the side of 0 on which a number is. */
const side = (x) => [Math.sign(x)]
/** Finds the two integers around a number, or the integer that it is. */
const step = (x) => [Math.floor(x) + Math.ceil(x)]

const byComponent = {
  abs: side,
  sign: side,
  floor: step,
  ceil: step,
  trunc: step,
  fract: step,
  round: (x) => step(x + 0.5),
  mod: (x, y) => step(x / y),
}
const comparisons = `step min max clamp vecMin vecMax vecClamp smoothstep lt le gt ge eq ne`
for (const op of comparisons.split(' ')) byComponent[op] = order

const dot = (v, w) => v.reduce((sum, x, i) => sum + x * w[i], 0)

const vectorOperations = {
  faceforward: (_, v, reference) => side(dot(reference, v)),
  // Total reflection begins where this is below zero.
  refract: (v, normal, [eta]) => side(1 - eta * eta * (1 - dot(normal, v) ** 2)),
  length: (v) => side(dot(v, v)),
  normalize: (v) => side(dot(v, v)),
  dist: (v, w) => [v.every((x, i) => x === w[i])],
}
vectorOperations.distance = vectorOperations.dist

/** Returns the choices of an expression at a point, as a string. `around`, as for `evaluate`, may change intermediate values. */
export function choicesAt(root, point, around = (_, values, compute) => compute(values)) {
  const choices = []
  const record = ({ op }, values) => {
    if (vectorOperations[op]) choices.push(...vectorOperations[op](...values))
    const choose = byComponent[op]
    const size = choose ? Math.max(...values.map(({ length }) => length)) : 0
    for (let i = 0; i < size; i++)
      choices.push(...choose(...values.map((value) => value[value.length === 1 ? 0 : i])))
  }
  evaluate(root, point, {
    around: (node, values, compute) =>
      around(node, values, (changed) => {
        record(node, changed)
        return compute(changed)
      }),
  })
  return choices.join()
}
