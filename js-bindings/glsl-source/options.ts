// The options of all functions that read source in GLSL or WGSL.
import { maxIterationsKind } from '../options/iterations.js'
import { kind, optional, text } from '../options/kinds.js'
import type { KindsOf } from '../options/schema.js'

export interface GlslOptions {
  /** The name of the function. Default: `offset` or, if the source has no such function, the last one. */
  function?: string
  /**
   * Max number of iterations, from 1 to 4096, of every loop whose end depends on values in the shader. A loop that goes on for longer is
   * cut off there, without a message. Nested loops of this kind multiply it, to at most 10,000. Without this option such a loop is
   * unsupported.
   */
  maxIterations?: number
}

export const glslKinds = {
  function: optional(text('the name of a function')),
  /** 0 if the option is missing. */
  maxIterations: maxIterationsKind(0),
} satisfies KindsOf<GlslOptions>

const isFileName = (value: unknown) =>
  typeof value === 'string' && /^[\w./\\-]+\.\w+$/.test(value.trim())

export type SourceLanguage = 'glsl' | 'wgsl'

const sourceKindOf = (language: string) =>
  kind<string>(
    `a string of ${language}`,
    (value) => typeof value === 'string' && !isFileName(value),
    {
      advice: (value) =>
        isFileName(value)
          ? 'this is the name of a file; read the file first, by fetch or loadStrings for instance'
          : undefined,
    },
  )

export const sourceKinds: Record<SourceLanguage, ReturnType<typeof sourceKindOf>> = {
  glsl: sourceKindOf('GLSL'),
  wgsl: sourceKindOf('WGSL'),
}

/** Maps scalar types of GLSL → their names in WGSL. */
const wgslScalars: Record<string, string> = { float: 'f32', int: 'i32', uint: 'u32' }

/** Returns the name that a type of GLSL has in WGSL. */
export function wgslType(type: string): string {
  const [, base, size] = /^([iub]?)vec(\d)$/.exec(type) ?? []
  if (size) return base === 'b' ? `vec${size}<bool>` : `vec${size}${base || 'f'}`
  return wgslScalars[type] ?? type.replace(/^(mat)(\d)$/, '$1$2x$2').replace(/^(mat\dx\d)$/, '$1f')
}

/** Puts an indefinite article in front of a type, for messages. */
export const article = (type: string) => `${/^[aeio]|^f32/.test(type) ? 'an' : 'a'} ${type}`

/** Returns a type of GLSL as the language of the source names it, with an indefinite article. */
export const articleIn = (language: SourceLanguage, type: string) =>
  article(language === 'wgsl' ? wgslType(type) : type)
