/** The option `shader`: a shader that the sketch made by `modify` or `buildMaterialShader`, to which the warp is added. */
import { WarpError, describe } from '../errors/errors.js'
import { targetOf, type HookStyle } from './hooks/styles.js'
import type { Shader } from './host.js'
import type { OptionsWithDefaults, WarpSettings } from './settings.js'

/** Maps the sketch's shader to the uniforms that were set since it was passed to createWarp, for the warp's copies of the shader. */
const recordedUniforms = new WeakMap<Shader, Map<string, unknown>>()

/** Throws a `WarpError` if the warp cannot be added to the shader. */
export function checkShader(
  { shader, hooks }: OptionsWithDefaults,
  style: HookStyle,
  renderer: Parameters<typeof targetOf>[0],
) {
  if (!shader) return
  const vertex = shader.hooks?.vertex
  if (!vertex)
    throw new WarpError(
      `createWarp: the option "shader": expected a shader that modify() or buildMaterialShader() made, got ${describe(shader)}.`,
    )
  if (!('Vertex getObjectInputs' in vertex || 'vec3 getLocalNormal' in vertex))
    throw new WarpError(
      'createWarp: the option "shader": expected a shader of shapes, such as baseMaterialShader().modify(…), got one without hooks for the vertices of shapes.',
    )
  const isWgsl = targetOf(renderer) === 'wgsl'
  const glslHook = isWgsl && Object.keys(vertex).find((name) => /^\s*\(\w+ \w/.test(vertex[name]!))
  if (glslHook)
    throw new WarpError(
      `createWarp: the option "shader" has the hook ${glslHook.split(' ')[1]} in GLSL; on a WEBGPU canvas write it in WGSL or p5.strands.`,
    )
  const shaderRenderer = shader._renderer
  if (shaderRenderer && (targetOf(shaderRenderer) === 'wgsl') !== isWgsl)
    throw new WarpError(
      'createWarp: the option "shader" must be made on a canvas of the same kind, WEBGL or WEBGPU, as the canvas of the warp.',
    )
  if (hooks === 'last' && !style.canRunLast)
    throw new WarpError(
      'createWarp: on p5 1.11 the hooks of the shader always run first; leave the option "hooks" out.',
    )
  recordUniforms(shader)
}

function recordUniforms(shader: Shader) {
  if (recordedUniforms.has(shader)) return
  const recorded = new Map<string, unknown>()
  recordedUniforms.set(shader, recorded)
  const set = shader.setUniform
  shader.setUniform = (name, value) => {
    recorded.set(name, value)
    return set.call(shader, name, value)
  }
}

/** Sets the uniforms of the warp's copy to the values that the sketch has set in its own shader. */
export function copyUniforms({ shader }: WarpSettings, copy: Shader) {
  for (const [name, value] of (shader && recordedUniforms.get(shader)) ?? [])
    if (copy.uniforms[name]) copy.setUniform(name, value)
}
