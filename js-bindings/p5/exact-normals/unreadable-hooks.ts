/** Messages about hooks that `exactNormals` cannot read. They name calls of the sketch, not the source that p5 generated from it. */
import { WarpError, describe } from '../../errors/errors.js'
import type { ModifiedShader } from './modified-shader.js'

/** Maps a hook's name to the kind of shader that has it. */
const others: readonly (readonly [RegExp, string])[] = [
  [/^StrokeVertex /, 'a shader of lines, which have no normals; draw with it as it is'],
  [/^vec4(?:<f32>)? getColor$/, 'a filter, which moves no vertices; use it as it is'],
]

/** Describes what was passed in place of a shader of surfaces. */
export function describeShader(given: unknown): string {
  const shader = given as (ModifiedShader & { vertSrc?: unknown }) | undefined
  const { vertex = {}, fragment = {} } = shader?.hooks ?? {}
  const names = [...Object.keys(vertex), ...Object.keys(fragment)]
  const found = others.find(([pattern]) => names.some((name) => pattern.test(name)))
  if (found) return found[1]
  // On 1.11 they have no hook of their own.
  if ('vec3 getLocalPosition' in vertex) return others[0]![1]
  return typeof shader?.vertSrc === 'function'
    ? 'one without hooks, such as createShader() and loadShader() make'
    : describe(given)
}

/** p5's own text, which it puts above all hooks, whichever calls it. */
export const withoutRandom = (text: string) =>
  text.replace(/^float random\(float seed\) \{[^]*?^\}/m, '')

/** Throws a `WarpError` for what makes a place that has no slope, or that the CPU and the derivative cannot see. */
export function checkReadable(shader: ModifiedShader, name: string, hook: string) {
  const word = name.split(' ')[1]
  const text = [hook, ...Object.values(shader.hooks.helpers)].join('\n')
  const isRandom = [...Object.values(shader.hooks.vertex), shader.hooks.declarations ?? ''].some(
    (each) => each.includes('_p5_randomCallIndex'),
  )
  if (isRandom && /\brandom\(/.test(text))
    throw new WarpError(
      `random() in ${word} gives each vertex a number of its own, so that the surface has no slope between them; write noise(), which is smooth.`,
    )
  const read = Object.keys(shader.hooks.storageUniforms ?? {})
    .map((key) => key.split(':')[0]!.trim())
    .find((storage) => new RegExp(`\\b${storage}\\s*\\[`).test(text))
  if (read)
    throw new WarpError(
      `uniformStorage() "${read}" in ${word} is a list in the memory of the GPU, of which nothing is known here; hand over numbers by uniformFloat(), uniformVec3() and the like, or an image by uniformTexture().`,
    )
}

/** A sentence about the text that p5.strands made, which nobody wrote, without its lines. */
export const inStrandsWords = (message: string, word: string) =>
  `p5.strands makes of ${word} what exactNormals cannot read (${message
    .replace(/^(?:glslOffset: )?line \d+, column \d+: /, '')
    .split('\n')[0]!
    .replace(/[.;]?$/, '')}); write the motion for createWarp.`

/** Names that p5.strands gives. */
export const isOfStrands = (hook: string) => /\b_p5_param_/.test(hook)
