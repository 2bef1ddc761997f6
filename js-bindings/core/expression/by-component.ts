// Accepts vectors as separate numbers, as methods of p5.Vector do: `v.mult(x, y, z)` is `v.mult(glsl.vec3(x, y, z))`.
import { describeShape } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import type { Expression } from './expression.js'
import { operationNamed } from './operations.js'
import type { Session } from './session.js'

/** Maps an operation → the number of operands that follow the numbers. */
const trailingOperands: Readonly<Record<string, number>> = {
  add: 0,
  sub: 0,
  mult: 0,
  div: 0,
  mod: 0,
  dot: 0,
  cross: 0,
  dist: 0,
  distance: 0,
  mix: 1,
}

/** Tests for an operation that takes any number of operands: if too few numbers were passed, it would apply each to all components. */
const isChained = (name: string) => /^(?:add|sub|mult|div)$/.test(name)

/**
 * Replaces numbers among the operands by one vector. Throws a `WarpError` if there are not as many numbers as the first operand has
 * components.
 */
export function gatherNumbers(session: Session, name: string, operands: Expression[]) {
  if (operands.length < 3) return operands
  const trailing = trailingOperands[name]
  if (trailing === undefined || operands.length < 3 + trailing) return operands
  const [columns, rows] = session.shapeOf(operands[0]!)
  const numbers = operands.slice(1, operands.length - trailing)
  const isNumber = (each: Expression) => session.shapeOf(each).join() === '1,1'
  if (columns > 1 || rows < 2 || !numbers.every(isNumber)) return operands
  if (numbers.length === rows) {
    const vector = session.call(operationNamed(`vec${rows}`), numbers)
    return [operands[0]!, vector, ...operands.slice(1 + rows)]
  }
  if (!isChained(name)) return operands
  const vector = describeShape([columns, rows])
  throw new WarpError(
    `${name}: ${vector} takes one number for all components or ${rows}, one for each, but got ${numbers.length}; write v.${name}(glsl.vec${rows}(…)), or v.${name}(a).${name}(b).`,
  )
}
