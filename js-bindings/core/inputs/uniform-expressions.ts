// The argument `uniforms` of an offset function: an expression or an image's name for each uniform that the option declares.
import type { Session } from '../expression/session.js'
import { WarpError } from '../../errors/errors.js'
import { asOwn, readOperators } from '../../errors/operators.js'
import type { Expression } from '../expression/expression.js'
import { imageShape } from '../expression/shapes.js'
import { lazyObject } from '../lazy-object.js'
import type { OffsetFunction, WarpInputs } from '../types/types.js'
import { type DeclaredUniforms, listNames } from './declared-uniforms.js'
import { markWhole } from './inputs.js'
import { checkWhole, readAsWhole } from './uniform-values.js'

/** The offset function, with its operators read, and with `uniforms` among its inputs; `labelOf` gives what the shader calls them. */
export function withUniforms(
  method: string,
  offset: OffsetFunction,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string,
): OffsetFunction {
  const read = readOperators(offset, { method })
  return asOwn((inputs: WarpInputs) => {
    const strings = Reflect.ownKeys(inputs).filter((name) => typeof name === 'string')
    const names = new Map([...strings, 'uniforms'].map((name) => [name, true]))
    const make = (name: string) => {
      if (name !== 'uniforms') return inputs[name as keyof WarpInputs]
      const { session } = inputs.position as unknown as Expression
      return expressions(method, session as Session, declared, labelOf)
    }
    // The prototype throws for names that are no inputs.
    return read(lazyObject(Object.getPrototypeOf(inputs) as object, { names, make }) as WarpInputs)
  })
}

/** An object of expressions, and of images' names, which says so where there is none of that name. */
function expressions(
  method: string,
  session: Session,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string,
): WarpInputs['uniforms'] {
  const known = Object.create(null) as object
  for (const [name, { shape, sampling }] of declared) {
    const label = labelOf(name)
    if (sampling) session.samplings.set(label, sampling)
    Object.defineProperty(known, name, {
      enumerable: true,
      get: () =>
        shape === imageShape ? label : session.input(label, shape, `${method} uniforms.${name}`),
    })
  }
  Object.defineProperty(known, markWhole, {
    value: (name: string) => {
      const { shape, isFunction, numbers } = declared.get(name)!
      readAsWhole(shape)
      if (!isFunction) checkWhole(`${method}: the uniform "${name}"`, numbers(method))
    },
  })
  return new Proxy(known, {
    get(target, name) {
      if (name in target || typeof name === 'symbol') return Reflect.get(target, name)
      throw new WarpError(
        declared.size
          ? `${method}: the option "uniforms" declares no "${name}"; there are ${listNames(declared)}.`
          : `${method}: the offset reads uniforms.${name}, which nothing declares; add the option { uniforms: { ${name}: 0.5 } }.`,
      )
    },
    set(_, name) {
      throw new WarpError(
        `${method}: uniforms.${String(name)} cannot be set in the offset function; give its value in the option "uniforms", or where the warp is used.`,
      )
    },
  })
}
