/** Which style of hooks a canvas's shaders have, and p5's shaders with a warp in them. */
import { beside } from './beside.js'
import type { WarpText } from '../../compile/warp-text.js'
import type { Target } from '../../core/module/kept-module.js'
import { forgetLastShape } from '../variation/variation-buffers.js'
import { readsVariation, variationVariables } from '../variation/variation-text.js'
import type { Shader } from '../host.js'
import { inputUniforms } from '../sketch-uniforms.js'
import { structHooks } from './struct-hooks.js'
import type { HookStyle, Woven, WovenType } from './styles.js'
import { valueHooks } from './value-hooks.js'
import { wgslHooks } from './wgsl-hooks.js'

/** The style of p5's hooks in `base`; undefined where p5 has no hooks, before 1.11. */
export function hookStyleOf(base: Shader, target: Target): HookStyle | undefined {
  if (target === 'wgsl') return wgslHooks
  const hooks = base.hooks?.vertex ?? {}
  if ('Vertex getObjectInputs' in hooks) return structHooks
  return 'vec3 getWorldPosition' in hooks ? valueHooks : undefined
}

/** The expressions that `compileWarp` is to use for its inputs. */
export const namesFor = ({ names }: HookStyle) => ({
  ...names,
  ...variationVariables,
  ...inputUniforms,
})

/** p5's shader `base` with the warp in it. */
export function weave(base: Shader, style: HookStyle, woven: Woven, type: WovenType): Shader {
  const ours = style.fill(woven, type, base)
  const shader = base.modify(beside(base, ours, (name) => style.turnOf(name, woven)))
  style.finish?.(shader, woven)
  if (readsVariation(woven.text) && shader._renderer?.GL) forgetLastShape(shader)
  // p5 1.11 draws with a shader of its own in place of one that looks unlit under lights or untextured under texture().
  return Object.assign(shader, { isLightShader: () => true, isTextureShader: () => true })
}

/** What lines have, which is a place alone: no surface with a normal, no fill. */
export const isOfLines = ({ attributes }: WarpText) =>
  attributes.every(({ name }) => name === 'position')
