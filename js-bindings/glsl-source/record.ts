// A function of shader text that stays one: a module of its own, which texts call and the compiler differentiates.
import { Place } from '../options/place.js'
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { RecordedFunction, Session } from '../core/expression/session.js'

/** Calls it in the session of that builder, and gives its numbers. */
export type Routine = (glsl: Builder, operands: Expression[]) => Expression[]

const sessionOf = (glsl: Builder) => glsl.val!(0).session as Session

/**
 * Runs the body once, in a session whose inputs are the arguments: `size` numbers, by the first `variables` of which
 * there are derivatives. Equal bodies of one name have one name, and others another.
 */
export function record(
  glsl: Builder,
  name: string,
  size: number,
  variables: number,
  body: (inner: Builder, operands: Expression[]) => Expression[],
): Routine {
  const outer = sessionOf(glsl)
  // This bundle has no session of its own.
  const inner = new (outer.constructor as typeof Session)(outer.target)
  const builderOf = glsl.of as unknown as (session: Session) => Builder
  try {
    const place = new Place(name)
    const operands = Array.from({ length: size }, (_, i) => inner.input(`x${i}`, [1, 1], name))
    const results = body(builderOf(inner), operands)
    results.forEach((result, i) => inner.output(`result${i}`, result, place))
    const module = inner.finish()
    const mark = module.reduce((hash, word) => Math.imul(hash ^ word, 0x01000193), variables)
    // Two underscores in a row are the language's.
    const own = name.replace(/_+/g, '_').replace(/_$/, '')
    const recorded: RecordedFunction = {
      name: `${own}_${(mark >>> 0).toString(36)}`,
      variables,
      results: results.length,
      module,
    }
    return (caller, operands) => sessionOf(caller).callRecorded(recorded, operands)
  } finally {
    inner.close()
  }
}
