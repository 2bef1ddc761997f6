// What every compilation takes and gives.
import { Compilation, type Gen, type Target } from './compilation.js'

/** How much work a result is. */
export interface Stats {
  /** Graph nodes that the results need, constants and inputs included. */
  nodes: number
  /** Those of them that compute something. */
  operations: number
  temporaries: number
}

export interface Compiled {
  /** Statements for the inside of a function; they declare and assign the results. */
  code: string
  /** Functions that `code` calls, for above `main`: the sources of `glsl.fn`, each once. */
  declarations: string
  /** The host's variables and expressions that the statements really read. */
  uniforms: string[]
  stats: Stats
}

export interface CompileOptions {
  /** The shading language; `'glsl300'` unless given. */
  target?: Target
}

/** Does some work with a compilation, and closes it whatever happens. */
export function withCompilation<Result>(
  target: Target = 'glsl300',
  work: (compilation: Compilation) => Result,
  gen?: Gen,
): Result {
  const compilation = new Compilation(target, gen)
  try {
    return work(compilation)
  } finally {
    compilation.close()
  }
}
