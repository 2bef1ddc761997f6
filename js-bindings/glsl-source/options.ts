// The options of all functions that read GLSL source.
import { kind, optional, text, wholeNumber } from '../options/kinds.js'
import type { KindsOf } from '../options/schema.js'

export interface GlslOptions {
  /** The name of the function. Default: `offset` or, if the source has no such function, the last one. */
  function?: string
  /** Max number of iterations of a loop whose end depends on values in the shader; without this option such a loop is unsupported. */
  maxIterations?: number
}

export const maxIterationLimit = 4096

export const glslKinds = {
  function: optional(text('the name of a function')),
  /** 0 if the option is missing. */
  maxIterations: wholeNumber({ min: 1, max: maxIterationLimit, default: 0 }),
} satisfies KindsOf<GlslOptions>

const isFileName = (given: unknown) =>
  typeof given === 'string' && /^[\w./\\-]+\.\w+$/.test(given.trim())

export const sourceKind = kind<string>(
  'a string of GLSL',
  (given) => typeof given === 'string' && !isFileName(given),
  {
    advice: (given) =>
      isFileName(given)
        ? 'this is the name of a file; read the file first, by fetch or loadStrings for instance'
        : undefined,
  },
)

/** Returns the type with an indefinite article, for messages. */
export const article = (type: string) => `${/^[aeio]/.test(type) ? 'an' : 'a'} ${type}`
