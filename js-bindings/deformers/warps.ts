// What all compositions check.
import { WarpError, describe, describeShape } from '../errors/errors.js'
import type { Expression } from '../core/expression/expression.js'
import { readOperators } from '../errors/operators.js'
import { isCallable } from '../options/options.js'
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { isExpression } from './kinds.js'

export function checkWarps(method: string, warps: readonly unknown[], first = 1) {
  if (warps.length === 0)
    throw new WarpError(`${method}: at least one offset function was expected, but none came.`)
  warps.forEach((warp, i) => {
    if (!isCallable(warp))
      throw new WarpError(
        `${method}: argument ${i + first} must be an offset function, such as twist({ angle: 1 }), but is ${describe(warp)}.`,
      )
  })
}

/** The offset of one of the warps; `number` is that of the argument. */
export function offsetOf(
  method: string,
  number: number,
  warp: OffsetFunction<never>,
  inputs: WarpInputs,
): Vec3 {
  const offset: unknown = readOperators(warp as OffsetFunction, { method })(inputs)
  const expected = `${method}: the offset function that is argument ${number} must return a vec3`
  if (!isExpression(offset))
    throw new WarpError(
      `${expected}, such as glsl.vec3(x, y, z), but returned ${describe(offset)}.`,
    )
  const { session } = inputs.position as unknown as Expression
  const [columns, rows] = session.shapeOf(offset as unknown as Expression)
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${expected}, but returned ${describeShape([columns, rows])}.`)
  return offset as Vec3
}
