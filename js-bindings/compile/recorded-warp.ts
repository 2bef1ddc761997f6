// Calls an offset function, once, and keeps what it did: everything else is written or run from there.
import { operationNamed } from '../core/expression/operations.js'
import { type Expression, toExpression } from '../core/expression/expression.js'
import type { Session } from '../core/expression/session.js'
import { type InputName, inputSizes } from '../core/inputs/inputs.js'
import { type KeptModule, resultsOf } from '../core/module/kept-module.js'
import { withSession } from '../core/module/result.js'
import type { OffsetFunction } from '../core/types/types.js'
import { isExpression } from '../errors/describe.js'
import { WarpError, describe, describeShape } from '../errors/errors.js'
import { Place } from '../options/place.js'
import { turnedResults, warpOperands, warpResults } from '../wasm/tables.js'
import { warpInputs } from './warp-inputs.js'
import type { Settings } from './warp-options.js'

export interface RecordedWarp {
  module: KeptModule
  settings: Settings
  /** Maps an input's name to its number in the module. */
  inputs: Readonly<Record<InputName, number>>
  /** `true` if the warped normal depends on how normal and uv vary over the surface. */
  varies: boolean
  /** `true` if texts treat them as constant all the same, and no option accepts that. */
  isApproximate: boolean
  /** The number of the offset's Jacobian among the results, if the settings ask for it. */
  jacobian: number | undefined
}

/** A result that a text may have. The Jacobian J of the offset is for directions t, which become t + J t. */
export type Result = 'offset' | 'position' | 'normal' | 'tangent' | 'jacobian'

/** The number of a result in the module. If the text knows how normal and uv vary over the surface, normals and tangents are others. */
export function resultNumber(
  { jacobian }: Pick<RecordedWarp, 'jacobian'>,
  result: Result,
  knowsVariation: boolean,
): number {
  if (result === 'jacobian') return jacobian!
  return knowsVariation ? onSurface(warpResults[result]) : warpResults[result]
}

/** The number of a result where normal and uv vary over the surface. */
export const onSurface = (result: number) =>
  result < warpResults.normal ? result : result + turnedResults

export function recordWarp(offsetFunction: OffsetFunction, settings: Settings): RecordedWarp {
  const { method, target, names, normals, surfaceVariation, isAccepted, debug } = settings
  const record = (session: Session): RecordedWarp => {
    const given: Record<string, Expression> = {}
    for (const [name, label] of Object.entries(names)) {
      given[name] = session.input(
        label,
        [1, inputSizes[name as InputName]],
        `${method} names.${name}`,
      )
      session.inputNames.set(label, name)
    }
    const offset = checkOffset(session, method, offsetFunction(warpInputs(session, given)))
    const operands = warpOperands.map((name) => given[name]!)
    const { varies } = session.warp(method, [offset, ...operands], normals, !surfaceVariation)
    const inputs = Object.fromEntries(
      Object.entries(given).map(([name, input]) => [name, session.numberOf(input)]),
    ) as RecordedWarp['inputs']
    const isApproximate = varies && !surfaceVariation && !isAccepted
    if (settings.jacobian) askJacobian(session, offset, given.position!)
    const module = session.finish()
    const jacobian = settings.jacobian ? resultsOf(module).length - 1 : undefined
    return { module, settings, inputs, varies, isApproximate, jacobian }
  }
  return withSession(target, record, { debug })
}

function askJacobian(session: Session, offset: Expression, position: Expression) {
  const jacobian = session.call(operationNamed('jacobian'), [offset, position])
  session.output('jacobian', jacobian, 'jacobian')
}

function checkOffset(session: Session, method: string, offset: unknown): Expression {
  const expected = 'the offset function must return a vec3, such as glsl.vec3(x, y, z)'
  if (!isExpression(offset))
    throw new WarpError(
      `${method}: ${expected}, but returned ${describe(offset)}${offset === undefined ? ' (is its "return" missing?)' : offset instanceof Promise ? ' (leave its "async" out)' : ''}.`,
    )
  const vector = toExpression(session, offset, new Place(method, 'the offset'))
  const [columns, rows] = session.shapeOf(vector)
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${method}: ${expected}, but returned ${describeShape([columns, rows])}.`)
  return vector
}
