// `glsl.texture`: reads an image of the host at texture coordinates. src/texture implements the interpolation.
import { describe, describeShape } from '../../errors/describe.js'
import { boolean, oneOf, optional, text } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { object, type KindsOf } from '../../options/schema.js'
import { filters, wraps } from '../../wasm/tables.js'
import type { TextureOptions } from '../types/types.js'
import { toExpression, type Expression } from './expression.js'
import { samplingUniforms } from './sampling.js'
import type { Session } from './session.js'

const isForUsers = <Name extends string>(name: Name | 'host'): name is Exclude<Name, 'host'> =>
  name !== 'host'

const place = new Place('texture')
const imageName = text('the name of a sampler2D, such as "heightMap",', /^[a-z_]\w*$/i)
const options = object({
  filter: optional(oneOf(filters.filter(isForUsers))),
  wrap: optional(oneOf(wraps.filter(isForUsers))),
  transform: boolean(true),
} satisfies KindsOf<TextureOptions>)

export function callTexture(
  session: Session,
  [name, uv, given, ...others]: readonly unknown[],
): Expression {
  const image = imageName.read(name, place.argument(1))
  const coordinates = toExpression(session, uv, place, 2)
  const shape = session.shapeOf(coordinates)
  if (`${shape}` !== '1,2') throw place.argument(2).expected('a vec2', describeShape(shape))
  if (others.length > 0)
    throw place.error(`it takes a name, a vec2 and options; ${describe(others[0])} is too many.`)
  const sampling = session.samplings.get(image)
  const { filter, wrap, transform: isTransformed } = options.read(given, place)
  const uniforms = samplingUniforms(image)
  return session.callTexture(
    image,
    isTransformed && sampling?.hasTransform
      ? transform(session.input(uniforms.transform, [3, 3], 'texture'), coordinates)
      : coordinates,
    filter ?? (sampling ? 'host' : 'bilinear'),
    wrap ?? (sampling ? 'host' : 'clamp'),
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
