// The options of all that reads shader text.
import { kind, optional, text, wholeNumber } from '../options/kinds.js'
import type { KindsOf } from '../options/schema.js'

export interface GlslOptions {
  /** The name of the function; `offset`, or the last one in the text, unless given. */
  function?: string
  /** How often a loop runs whose end depends on what only the shader knows; without it such a loop is refused. */
  maxIterations?: number
}

export const mostIterations = 4096

export const glslKinds = {
  function: optional(text('the name of a function')),
  /** 0 if it is left out. */
  maxIterations: wholeNumber({ min: 1, max: mostIterations, default: 0 }),
} satisfies KindsOf<GlslOptions>

const isFileName = (given: unknown) =>
  typeof given === 'string' && /^[\w./\\-]+\.\w+$/.test(given.trim())

export const sourceKind = kind<string>(
  'a text of GLSL',
  (given) => typeof given === 'string' && !isFileName(given),
  {
    advice: (given) =>
      isFileName(given)
        ? 'it is the name of a file, so read that first, as by fetch or loadStrings'
        : undefined,
  },
)

/** As GLSL writes it, in a sentence. */
export const article = (type: string) => `${/^[aeio]/.test(type) ? 'an' : 'a'} ${type}`
