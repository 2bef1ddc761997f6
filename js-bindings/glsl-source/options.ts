// What all that reads shader text is given.
import { WarpError, describe } from '../errors/errors.js'

export interface GlslOptions {
  /** The name of the function; `offset`, or the last one in the text, unless given. */
  function?: string
  /** How often a loop runs whose end depends on what only the shader knows; without it such a loop is refused. */
  maxIterations?: number
}

/** As GLSL writes it, in a sentence. */
export const article = (type: string) => `${/^[aeio]/.test(type) ? 'an' : 'a'} ${type}`

export function checkSource(method: string, source: unknown): asserts source is string {
  if (typeof source === 'string') {
    if (/^[\w./\\-]+\.\w+$/.test(source.trim()))
      throw new WarpError(
        `${method}: the source must be a text of GLSL, but is the name of a file, ${describe(source)}; read it first, as by fetch or loadStrings.`,
      )
    return
  }
  throw new WarpError(`${method}: the source must be a text of GLSL, but is ${describe(source)}.`)
}

export function readName(method: string, name: unknown): string | undefined {
  if (name === undefined || typeof name === 'string') return name
  throw new WarpError(`${method}: the option "function" must be a name, but is ${describe(name)}.`)
}

export const mostIterations = 4096

export function readIterations(method: string, count: unknown): number {
  if (count === undefined) return 0
  if (Number.isInteger(count) && (count as number) >= 1 && (count as number) <= mostIterations)
    return count as number
  throw new WarpError(
    `${method}: the option "maxIterations" must be a whole number from 1 to ${mostIterations}, but is ${describe(count)}.`,
  )
}
