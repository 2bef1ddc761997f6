/** Messages about hooks that `exactNormals` cannot read. They name calls of the sketch, not the source that p5 generated from it. */
import { WarpError, describe } from '../../errors/errors.js'
import { withoutLocation } from '../../glsl-source/generated.js'
import type { ModifiedShader } from './modified-shader.js'
import { place } from './place.js'

/** Patterns of hook names, each with a description of the shaders that have such a hook. */
const otherShaders: readonly (readonly [RegExp, string])[] = [
  [/^StrokeVertex /, 'a shader of lines, which have no normals; draw with it as it is'],
  [/^vec4(?:<f32>)? getColor$/, 'a filter, which moves no vertices; use it as it is'],
]

/** Describes a value that was passed but is not a shader for surfaces. */
export function describeShader(given: unknown): string {
  const shader = given as (ModifiedShader & { vertSrc?: unknown }) | undefined
  const { vertex = {}, fragment = {} } = shader?.hooks ?? {}
  const names = [...Object.keys(vertex), ...Object.keys(fragment)]
  const found = otherShaders.find(([pattern]) => names.some((name) => pattern.test(name)))
  if (found) return found[1]
  // On 1.11 shaders of lines have no hook of their own.
  if ('vec3 getLocalPosition' in vertex) return otherShaders[0]![1]
  return typeof shader?.vertSrc === 'function'
    ? 'one without hooks, such as createShader() and loadShader() make'
    : describe(given)
}

/** Removes p5's own random(), which p5 puts above every hook, called or not. */
export const withoutRandom = (text: string) =>
  text.replace(/^float random\(float seed\) \{[^]*?^\}/m, '')

/** p5's variable for the number of a vertex, from which its random() on WEBGPU computes the result. */
export const vertexId = '_p5VertexId'

export const randomError = (hookName: string) =>
  new WarpError(
    `random() in ${hookName} returns a different number for each vertex; expected calls outside of loops, branches and functions, on a WEBGPU canvas, so that the number is known to be constant at a vertex; or write noise(), which is smooth.`,
  )

/** Throws a `WarpError` for a hook in GLSL that calls p5's random(). */
export function rejectRandom(shader: ModifiedShader, hookName: string, hook: string) {
  const text = [hook, ...Object.values(shader.hooks.helpers)].join('\n')
  const isRandom = [...Object.values(shader.hooks.vertex), shader.hooks.declarations ?? ''].some(
    (each) => each.includes('_p5_randomCallIndex'),
  )
  if (isRandom && /\brandom\(/.test(text)) throw randomError(hookName)
}

export const storageError = (storage: string, hookName: string) =>
  new WarpError(
    `uniformStorage() "${storage}" in ${hookName} is read at an index that differs over the surface or counts in a loop; expected an index of numbers, instanceID() and uniforms, or an image by uniformTexture() in its place.`,
  )

/** Returns a message about source that p5.strands generated, without line numbers, since no user wrote those lines. */
export const strandsMessage = (message: string, hookName: string) =>
  `p5.strands generates source for ${hookName} that exactNormals cannot read (${withoutLocation(
    place.withoutMethod(message),
  )
    .split('\n')[0]!
    .replace(/[.;]?$/, '')}); write the motion for createWarp.`

/** Recognizes source of p5.strands by the names it generates. */
export const isGeneratedByStrands = (hook: string) => /\b_p5_param_/.test(hook)
