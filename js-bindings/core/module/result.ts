// The options and results of all compilers.
import { Session } from '../expression/session.js'
import { typeOf, type TypeName, type Variable } from '../expression/shapes.js'
import type { Recording } from '../expression/wasm-session.js'
import type { Target } from './serialized-module.js'

/** The cost of shader code. */
export interface Stats {
  /** The number of graph nodes that the results need, including constants and inputs. */
  nodes: number
  /** The number of nodes that compute something. */
  operations: number
  /** The number of variables, which hold values that are read more than once, or that would make a line too long. */
  temporaries: number
  /** The number of variables that are vectors, and so compute several components at once. */
  vectors: number
}

/** A variable that shader code reads, with the type that the host must declare. */
export interface Declared {
  name: string
  /** `'sampler2D'` is an image: a `texture_2d<f32>` in WGSL. */
  type: TypeName
}

export const toDeclared = ({ name, shape, read }: Variable): Declared => ({
  name,
  type: read?.type ?? typeOf(shape),
})

/** Lists each variable once: an integer is read as two halves of 16 bits, which are one variable. */
export const uniqueDeclared = (variables: readonly Variable[]): Declared[] =>
  [...new Map(variables.map((each) => [each.name, each])).values()].map(toDeclared)

export interface Compiled {
  /** Statements for the body of a function, which declare and assign the results. */
  code: string
  /** Functions that `code` calls, to be put above `main`, including the sources of `glsl.fn`. */
  declarations: string
  /** The host's variables and expressions that the statements read. */
  uniforms: Declared[]
  stats: Stats
}

export interface CompileOptions {
  /** The shading language.
   * @default 'glsl300' */
  target?: Target
}

/** Calls `work` with a new session, which is closed afterwards, also if `work` throws. */
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
