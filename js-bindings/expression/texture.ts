// `glsl.texture`: an image of the host as a function of texture coordinates. The interpolation is in src/texture.
import type { Session } from './session.js'
import { WarpError, describe, describeShape } from '../checks/errors.js'
import { type Expression, toExpression } from './expression.js'
import { checkOptions } from '../checks/options.js'
import { filters, wraps } from '../wasm/tables.js'

/** In the order of their numbers in the wasm. */
const choices: Record<string, readonly string[]> = { filter: filters, wrap: wraps }

export function callTexture(
  session: Session,
  [image, uv, options = {}, ...others]: readonly unknown[],
): Expression {
  if (typeof image !== 'string' || !/^[a-z_]\w*$/i.test(image))
    throw new WarpError(
      `texture: argument 1 must be the name of a sampler2D, such as "heightMap", but is ${describe(image)}.`,
    )
  const operand = toExpression(session, 'texture', uv, 2)
  const shape = session.shapeOf(operand)
  if (`${shape}` !== '1,2')
    throw new WarpError(`texture: argument 2 must be a vec2, but is ${describeShape(shape)}.`)
  if (others.length > 0)
    throw new WarpError(
      `texture: it takes a name, a vec2 and options; ${describe(others[0])} is too many.`,
    )
  checkOptions('texture', options, Object.keys(choices))
  const [filter, wrap] = Object.entries(choices).map(([option, names]) => {
    const { [option]: given = names[0] } = options as Record<string, unknown>
    const number = names.indexOf(given as string)
    if (number >= 0) return number
    throw new WarpError(
      `texture: the option "${option}" must be one of ${names.join(', ')}, but is ${describe(given)}.`,
    )
  })
  return session.callTexture(image, operand, filter!, wrap!)
}
