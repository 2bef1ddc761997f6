// The kind of the offset functions that are arguments of compositions.
import type { Expression } from '../core/expression/expression.js'
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { describe, describeShape } from '../errors/describe.js'
import { translateOperators } from '../errors/operators.js'
import { callable, type Kind } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { isExpression, type Computed } from './kinds.js'

const offsetFunction = callable<OffsetFunction>('an offset function, such as twist({ angle: 1 }),')

/** The kind of an offset function, whose result is checked when it is called. */
export const warp: Kind<Computed<Vec3>, OffsetFunction> = {
  read(passed, place) {
    const offset = translateOperators(offsetFunction.read(passed, place), { method: place.method })
    return (inputs) => offsetOf(offset, inputs, place)
  },
}

/** Reads the arguments of a composition, at least one offset function. */
export function warpsOf(place: Place, passed: readonly unknown[]): Computed<Vec3>[] {
  if (passed.length === 0) throw place.expected('at least one offset function', 'none')
  return passed.map((each, i) => warp.read(each, place.argument(i + 1)))
}

function offsetOf(warp: OffsetFunction, inputs: WarpInputs, place: Place): Vec3 {
  const offset: unknown = warp(inputs)
  const expected = `expected the offset function that is ${place.subject} to return a vec3`
  if (!isExpression(offset))
    throw place.error(`${expected}, such as glsl.vec3(x, y, z), got ${describe(offset)}.`)
  const { session } = inputs.position as unknown as Expression
  const [columns, rows] = session.shapeOf(offset as unknown as Expression)
  if (columns !== 1 || rows !== 3)
    throw place.error(`${expected}, got ${describeShape([columns, rows])}.`)
  return offset as Vec3
}
