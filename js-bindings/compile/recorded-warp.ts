// Calls an offset function, once, and records it as a module, from which shader code and CPU programs are made.
import { toExpression, type Expression } from '../core/expression/expression.js'
import { operationNamed } from '../core/expression/operations.js'
import type { Session } from '../core/expression/session.js'
import { inputSizes, type InputName } from '../core/inputs/inputs.js'
import { withSession } from '../core/module/result.js'
import { resultsOf, type SerializedModule } from '../core/module/serialized-module.js'
import type { OffsetFunction } from '../core/types/types.js'
import { isExpression } from '../errors/describe.js'
import { describe, describeShape } from '../errors/errors.js'
import { Place } from '../options/place.js'
import { variantCount, warpOperands, warpResults } from '../wasm/tables.js'
import { warpInputs } from './warp-inputs.js'
import type { Settings } from './warp-options.js'

export interface RecordedWarp {
  module: SerializedModule
  settings: Settings
  /** Maps an input's name to its number in the module. */
  inputs: Readonly<Record<InputName, number>>
  /** True if the warped normal depends on how normal and uv vary over the surface. */
  varies: boolean
  /** True if shader code treats normal and uv as constant nevertheless, and no option of the user accepts that. */
  isApproximate: boolean
  /** The number of the offset's Jacobian among the results. Present if the settings request it. */
  jacobian: number | undefined
  /** The number of the result `other0`; `other1` … follow. These are the expressions of `RecordOptions.others`. */
  firstOther: number
  otherCount: number
}

/** A result of shader code. The Jacobian J of the offset transforms a direction t into t + J t. */
export type Result = 'offset' | 'position' | 'normal' | 'tangent' | 'jacobian' | `other${number}`

/**
 * Returns the number of a result in the module. `knowsVariation` selects normals and tangents that take into account how normal and uv vary
 * over the surface.
 */
export function resultNumber(
  { jacobian, firstOther }: Pick<RecordedWarp, 'jacobian' | 'firstOther'>,
  result: Result,
  knowsVariation: boolean,
): number {
  if (result === 'jacobian') return jacobian!
  if (isOther(result)) return firstOther + Number(result.slice('other'.length))
  return knowsVariation ? onSurface(warpResults[result]) : warpResults[result]
}

const isOther = (result: Result): result is `other${number}` => result.startsWith('other')

/** Returns the number of the variant of a result that takes into account how normal and uv vary over the surface. */
export const onSurface = (result: number) =>
  result < warpResults.normal ? result : result + variantCount

export function recordWarp(offsetFunction: OffsetFunction, settings: Settings): RecordedWarp {
  const { place, target, names, normals, surfaceVariation, isAccepted, debug } = settings
  const record = (session: Session): RecordedWarp => {
    const inputExpressions: Record<string, Expression> = {}
    for (const [name, label] of Object.entries(names)) {
      inputExpressions[name] = session.input(
        label,
        [1, inputSizes[name as InputName]],
        `${place.method} names.${name}`,
      )
      session.inputNames.set(label, name)
    }
    const offset = readOffset(session, place, offsetFunction(warpInputs(session, inputExpressions)))
    const operands = warpOperands.map((name) => inputExpressions[name]!)
    const { varies } = session.warp(place, [offset, ...operands], normals, !surfaceVariation)
    const inputs = Object.fromEntries(
      Object.entries(inputExpressions).map(([name, input]) => [name, session.numberOf(input)]),
    ) as RecordedWarp['inputs']
    const isApproximate = varies && !surfaceVariation && !isAccepted
    if (settings.jacobian) addJacobian(session, offset, inputExpressions.position!)
    const others = settings.others()
    for (const [i, each] of others.entries()) session.output(`other${i}`, each, place)
    const module = session.finish()
    const firstOther = resultsOf(module).length - others.length
    const jacobian = settings.jacobian ? firstOther - 1 : undefined
    const numbers = { jacobian, firstOther, otherCount: others.length }
    return { module, settings, inputs, varies, isApproximate, ...numbers }
  }
  return withSession(target, record, { debug })
}

const jacobianPlace = new Place('jacobian')

/** Adds the Jacobian of the offset to the results. */
function addJacobian(session: Session, offset: Expression, position: Expression) {
  const jacobian = session.call(operationNamed('jacobian'), [offset, position])
  session.output('jacobian', jacobian, jacobianPlace)
}

function readOffset(session: Session, place: Place, offset: unknown): Expression {
  const resultError = (got: string) =>
    place.error(
      `the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned ${got}.`,
    )
  if (offset === undefined) throw resultError('undefined (is its "return" missing?)')
  if (offset instanceof Promise) throw resultError('a promise (leave its "async" out)')
  if (!isExpression(offset)) throw resultError(describe(offset))
  const vector = toExpression(session, offset, place.part('the offset'))
  const [columns, rows] = session.shapeOf(vector)
  if (columns !== 1 || rows !== 3) throw resultError(describeShape([columns, rows]))
  return vector
}
