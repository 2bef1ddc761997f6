/** Finds the style of hooks that a canvas's shaders have, and adds a warp to p5's shaders. */
import type { HostText, Target } from '../../compile/hosts.js'
import type { Shader } from '../host.js'
import { inputUniforms } from '../sketch-uniforms.js'
import { forgetLastShape } from '../variation/variation-buffers.js'
import { readsVariation, variationVariables } from '../variation/variation-text.js'
import { mergeHooks } from './merge-hooks.js'
import { structHooks } from './struct-hooks.js'
import type { HookStyle, MaterialKind, WarpCode } from './styles.js'
import { valueHooks } from './value-hooks.js'
import { wgslHooks } from './wgsl-hooks.js'

/** Returns the style of p5's hooks in `base`; `undefined` before p5 1.11, which introduced hooks. */
export function hookStyleOf(base: Shader, target: Target): HookStyle | undefined {
  if (target === 'wgsl') return wgslHooks
  const hooks = base.hooks?.vertex ?? {}
  if ('Vertex getObjectInputs' in hooks) return structHooks
  return 'vec3 getWorldPosition' in hooks ? valueHooks : undefined
}

/** Returns the expressions that the warp's code uses for its inputs. */
export const namesFor = ({ names }: HookStyle) => ({
  ...names,
  ...variationVariables,
  ...inputUniforms,
})

/** Returns p5's shader `base` with the warp in it. */
export function addWarp(
  base: Shader,
  style: HookStyle,
  warpCode: WarpCode,
  type: MaterialKind,
): Shader {
  const ours = style.hooksForFills(warpCode, type, base)
  const shader = base.modify(mergeHooks(base, ours, (name) => style.orderOf(name, warpCode)))
  style.finish?.(shader, warpCode)
  if (readsVariation(warpCode.text) && shader._renderer?.GL) forgetLastShape(shader)
  // p5 1.11 replaces a shader that looks unlit under lights, or untextured under texture(), with its own shader.
  return Object.assign(shader, { isLightShader: () => true, isTextureShader: () => true })
}

/** Returns whether the warp can move lines, which have a position, but neither a normal nor a fill. */
export const canMoveLines = ({ attributes }: HostText) =>
  attributes.every(({ name }) => name === 'position')
