/** The option `shader`: a shader that the sketch made by `modify` or `buildMaterialShader`, for a warp to be put on. */
import { WarpError, describe } from '../errors/errors.js'
import type { Shader } from './host.js'
import { type HookStyle, targetOf } from './hooks/styles.js'
import type { WarpSettings } from './settings.js'

/** What the sketch has set of a shader since it was handed over, for the warp's copies of it. */
const values = new WeakMap<Shader, Map<string, unknown>>()

/** Throws a `WarpError` where the warp cannot be put on the shader. */
export function checkShader(
  { shader, hooks }: WarpSettings,
  style: HookStyle,
  renderer: Parameters<typeof targetOf>[0],
) {
  if (!shader) return
  const vertex = shader.hooks?.vertex
  if (!vertex)
    throw new WarpError(
      `createWarp: the option "shader" must be a shader that modify() or buildMaterialShader() made, but is ${describe(shader)}.`,
    )
  if (!('Vertex getObjectInputs' in vertex || 'vec3 getLocalNormal' in vertex))
    throw new WarpError(
      'createWarp: the option "shader" must be one of shapes, such as baseMaterialShader().modify(…); this one has no hooks for the vertices of shapes.',
    )
  const isWgsl = targetOf(renderer) === 'wgsl'
  const inGlsl = isWgsl && Object.keys(vertex).find((name) => /^\s*\(\w+ \w/.test(vertex[name]!))
  if (inGlsl)
    throw new WarpError(
      `createWarp: the option "shader" has the hook ${inGlsl.split(' ')[1]} in GLSL; on a WEBGPU canvas write it in WGSL or p5.strands.`,
    )
  const own = shader._renderer
  if (own && (targetOf(own) === 'wgsl') !== isWgsl)
    throw new WarpError(
      'createWarp: the option "shader" must be made on a canvas of the same kind, WEBGL or WEBGPU, as the one of the warp.',
    )
  if (hooks === 'last' && !style.isOrdered)
    throw new WarpError(
      'createWarp: on p5 1.11 the hooks of the shader come first; leave the option "hooks" out.',
    )
  remember(shader)
}

function remember(shader: Shader) {
  if (values.has(shader)) return
  const known = new Map<string, unknown>()
  values.set(shader, known)
  const set = shader.setUniform
  shader.setUniform = (name, value) => {
    known.set(name, value)
    return set.call(shader, name, value)
  }
}

/** Hands what the sketch has set of its shader on to the warp's copy. */
export function passOn({ shader }: WarpSettings, copy: Shader) {
  for (const [name, value] of (shader && values.get(shader)) ?? [])
    if (copy.uniforms[name]) copy.setUniform(name, value)
}
