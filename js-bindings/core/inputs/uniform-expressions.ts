// The argument `uniforms` of an offset function: maps the name of a declared uniform → its expression or, for an image, the image's name
// in the shader.
import { markLibraryFunction, translateOperators } from '../../errors/operators.js'
import type { Place } from '../../options/place.js'
import type { Expression } from '../expression/expression.js'
import type { Session } from '../expression/session.js'
import { imageShape } from '../expression/shapes.js'
import { lazyObject } from '../lazy-object.js'
import type { OffsetFunction, WarpInputs } from '../types/types.js'
import { listNames, type DeclaredUniforms } from './declared-uniforms.js'
import { markWhole } from './inputs.js'
import { checkWhole, markAsWhole } from './uniform-values.js'

/**
 * Wraps an offset function: translates its operators, and adds `uniforms` to its inputs. `labelOf` returns the name of a uniform
 * in the shader.
 */
export function withUniforms(
  place: Place,
  offset: OffsetFunction,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string,
): OffsetFunction {
  const translated = translateOperators(offset, { method: place.method })
  return markLibraryFunction((inputs: WarpInputs) => {
    const strings = Reflect.ownKeys(inputs).filter((name) => typeof name === 'string')
    const names = new Map([...strings, 'uniforms'].map((name) => [name, true]))
    const make = (name: string) => {
      if (name !== 'uniforms') return inputs[name as keyof WarpInputs]
      const { session } = inputs.position as unknown as Expression
      return uniformExpressions(place, session as Session, declared, labelOf)
    }
    // The prototype of `inputs` throws for names that are no inputs.
    return translated(
      lazyObject(Object.getPrototypeOf(inputs) as object, { names, make }) as WarpInputs,
    )
  })
}

/** Makes an object that has the expressions, and the names of images, and throws for an undeclared name. */
function uniformExpressions(
  place: Place,
  session: Session,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string,
): WarpInputs['uniforms'] {
  const uniforms = Object.create(null) as object
  for (const [name, { shape, sampling }] of declared) {
    const label = labelOf(name)
    if (sampling) session.samplings.set(label, sampling)
    Object.defineProperty(uniforms, name, {
      enumerable: true,
      get: () =>
        shape === imageShape
          ? label
          : session.input(label, shape, `${place.method} uniforms.${name}`),
    })
  }
  Object.defineProperty(uniforms, markWhole, {
    value: (name: string) => {
      const { shape, isFunction, numbers } = declared.get(name)!
      markAsWhole(shape)
      if (!isFunction) checkWhole(place.uniform(name), numbers(place))
    },
  })
  return new Proxy(uniforms, {
    get(target, name) {
      if (name in target || typeof name === 'symbol') return Reflect.get(target, name)
      throw place.error(
        declared.size
          ? `the option "uniforms" declares no "${name}"; it declares ${listNames(declared)}.`
          : `the offset reads uniforms.${name}, which nothing declares; add the option { uniforms: { ${name}: 0.5 } }.`,
      )
    },
    set(_, name) {
      throw place.error(
        `uniforms.${String(name)} cannot be set in the offset function; set its value in the option "uniforms", or where the warp is used.`,
      )
    },
  })
}
