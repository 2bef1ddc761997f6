// Records a function of GLSL source as a separate module, which remains a function in the generated code and is differentiated as a whole.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { RecordedFunction, Session } from '../core/expression/session.js'
import { Place } from '../options/place.js'

/** Calls the recorded function in the session of a builder, and returns its results, one expression per number. */
export type Routine = (glsl: Builder, operands: Expression[]) => Expression[]

export const sessionOf = (glsl: Builder) => glsl.val!(0).session as Session

/**
 * Records a function by running `body` once, in a session whose inputs are the arguments: `size` numbers, of which the first `variables`
 * have derivatives. The generated name includes a hash of the body, so that functions with equal names and different bodies stay distinct.
 */
export function record(
  glsl: Builder,
  name: string,
  size: number,
  variables: number,
  body: (inner: Builder, operands: Expression[]) => Expression[],
): Routine {
  const outer = sessionOf(glsl)
  // The class is taken from the object, since this bundle does not contain Session.
  const inner = new (outer.constructor as typeof Session)(outer.target)
  const builderOf = glsl.of as unknown as (session: Session) => Builder
  try {
    const place = new Place(name)
    const operands = Array.from({ length: size }, (_, i) => inner.input(`x${i}`, [1, 1], name))
    const results = body(builderOf(inner), operands)
    results.forEach((result, i) => inner.output(`result${i}`, result, place))
    const module = inner.finish()
    const hash = module.reduce((hash, word) => Math.imul(hash ^ word, 0x01000193), variables)
    // GLSL reserves names with two consecutive underscores.
    const validName = name.replace(/_+/g, '_').replace(/_$/, '')
    const recorded: RecordedFunction = {
      name: `${validName}_${(hash >>> 0).toString(36)}`,
      variables,
      results: results.length,
      module,
    }
    return (caller, operands) => sessionOf(caller).callRecorded(recorded, operands)
  } finally {
    inner.close()
  }
}
