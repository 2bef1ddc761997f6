// The argument of an offset function: the inputs of a vertex and of a draw call, as expressions.
import { createBuilder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { callable } from '../core/expression/methods.js'
import type { Session } from '../core/expression/session.js'
import { inputSizes, variationInputs } from '../core/inputs/inputs.js'
import { lazyObject } from '../core/lazy-object.js'
import type { WarpInputs } from '../core/types/types.js'
import { didYouMean, throwingPrototype } from '../errors/nearest.js'

const componentOf = (session: Session, vector: Expression, i: number) =>
  session.swizzle('xyz'[i]!, vector, [i])

/** Maps names that users know from other tools → ours, for "did you mean". */
const meant = {
  time: 'millis',
  frameCount: 'millis',
  texCoord: 'uv',
  texcoord: 'uv',
  vertex: 'position',
  pos: 'position',
  resolution: 'size',
}

/** The inputs that an offset function gets by their own names. */
const inputNames = Object.keys(inputSizes).filter(
  (name) => name !== 'tangent' && !(name in variationInputs),
)

/** Components with names of their own. */
const namedComponents = {
  mouseX: ['mouse', 0],
  mouseY: ['mouse', 1],
  width: ['size', 0],
  height: ['size', 1],
} as const

const offsetInputs = new Map(
  ['glsl', ...inputNames, ...Object.keys(namedComponents)].map((name) => [name, true]),
)

export function warpInputs(session: Session, inputs: Record<string, Expression>): WarpInputs {
  // Needed even if the offset does not read it: the first builder installs the methods of expressions.
  const glsl = createBuilder(session)
  const make = (name: string) => {
    if (name === 'glsl') return glsl
    const [vector, i] = namedComponents[name as keyof typeof namedComponents] ?? []
    // Inputs can be called, as millis() in p5 and as components can.
    return callable(name, vector ? componentOf(session, inputs[vector]!, i!) : inputs[name]!)
  }
  const names = [...offsetInputs.keys()]
  const unknown = (name: string) =>
    `An offset function gets no "${name}"; ${didYouMean(name, names, `it gets ${names.join(', ')}, and uniforms by the option "uniforms".`, meant)}`
  return lazyObject(throwingPrototype(unknown), { names: offsetInputs, make }) as WarpInputs
}
