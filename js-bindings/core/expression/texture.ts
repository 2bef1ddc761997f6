// `glsl.texture`: an image of the host as a function of texture coordinates. The interpolation is in src/texture.
import type { Session } from './session.js'
import { WarpError, describe, describeShape } from '../../errors/errors.js'
import { type Expression, toExpression } from './expression.js'
import { checkOptions } from '../../options/options.js'
import { filters, wraps } from '../../wasm/tables.js'
import { samplingUniforms } from './sampling.js'

const isForUsers = (name: string) => name !== 'host'

/** Reads the option; without it, `otherwise`. The result is its number in the wasm. */
function readChoice(option: string, names: readonly string[], given: unknown, otherwise: string) {
  const number = names.indexOf((given ?? otherwise) as string)
  if (number >= 0 && (given === undefined || isForUsers(given as string))) return number
  throw new WarpError(
    `texture: the option "${option}" must be one of ${names.filter(isForUsers).join(', ')}, but is ${describe(given)}.`,
  )
}

export function callTexture(
  session: Session,
  [image, uv, options = {}, ...others]: readonly unknown[],
): Expression {
  if (typeof image !== 'string' || !/^[a-z_]\w*$/i.test(image))
    throw new WarpError(
      `texture: argument 1 must be the name of a sampler2D, such as "heightMap", but is ${describe(image)}.`,
    )
  const place = toExpression(session, 'texture', uv, 2)
  const shape = session.shapeOf(place)
  if (`${shape}` !== '1,2')
    throw new WarpError(`texture: argument 2 must be a vec2, but is ${describeShape(shape)}.`)
  if (others.length > 0)
    throw new WarpError(
      `texture: it takes a name, a vec2 and options; ${describe(others[0])} is too many.`,
    )
  checkOptions('texture', options, ['filter', 'wrap', 'transform'])
  const { filter, wrap, transform: isTransformed = true } = options as Record<string, unknown>
  if (typeof isTransformed !== 'boolean')
    throw new WarpError(
      `texture: the option "transform" must be true or false, but is ${describe(isTransformed)}.`,
    )
  const sampling = session.samplings.get(image)
  const uniforms = samplingUniforms(image)
  return session.callTexture(
    image,
    isTransformed && sampling?.hasTransform
      ? transform(session.input(uniforms.transform, [3, 3], 'texture'), place)
      : place,
    readChoice('filter', filters, filter, sampling ? 'host' : 'bilinear'),
    readChoice('wrap', wraps, wrap, sampling ? 'host' : 'clamp'),
    sampling && session.input(uniforms.settings, [1, 3], 'texture'),
  )
}

/** Returns (matrix * (u, v, 1)).xy. */
function transform(matrix: Expression, uv: Expression): Expression {
  const methods = (value: Expression) =>
    value as unknown as Record<string, (...operands: unknown[]) => Expression>
  const column = (i: number) => methods(methods(matrix).column!(i)).xy!()
  const across = methods(column(0)).mult!(methods(uv).x!())
  const down = methods(column(1)).mult!(methods(uv).y!())
  return methods(methods(across).add!(down)).add!(column(2))
}
