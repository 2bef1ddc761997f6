// What every session takes and gives.
import { Session, type Recording } from '../expression/session.js'
import type { Target } from './serialized-module.js'
import { type TypeName, type Variable, typeOf } from '../expression/shapes.js'

/** How much work a result is. */
export interface Stats {
  /** Graph nodes that the results need, constants and inputs included. */
  nodes: number
  /** Those of them that compute something. */
  operations: number
  /** Variables that hold what is read more than once, or what would be too long a line. */
  temporaries: number
  /** Those of them that are vectors: what is done to several components at once. The others are single. */
  vectors: number
}

/** What a text reads, with the type that the host is to declare. */
export interface Declared {
  name: string
  /** `'sampler2D'` is an image: a `texture_2d<f32>` of WGSL. */
  type: TypeName
}

export const declared = ({ name, shape, read }: Variable): Declared => ({
  name,
  type: read?.type ?? typeOf(shape),
})

/** Each once: the halves of a whole number are one variable. */
export const declaredOf = (variables: readonly Variable[]): Declared[] =>
  [...new Map(variables.map((each) => [each.name, each])).values()].map(declared)

export interface Compiled {
  /** Statements for the inside of a function; they declare and assign the results. */
  code: string
  /** Functions that `code` calls, for above `main`: the sources of `glsl.fn`, each once. */
  declarations: string
  /** The host's variables and expressions that the statements really read. */
  uniforms: Declared[]
  stats: Stats
}

export interface CompileOptions {
  /** The shading language; `'glsl300'` unless given. */
  target?: Target
}

/** Does some work with a session, and closes it whatever happens. */
export function withSession<Result>(
  target: Target,
  work: (session: Session) => Result,
  recording?: Recording,
): Result {
  const session = new Session(target, recording)
  try {
    return work(session)
  } finally {
    session.close()
  }
}
