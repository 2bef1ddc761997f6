/** The shaders of one warp for one renderer: each is made when it is first drawn with. */
import { type KeptWarp, writeMoves, writeWarp } from '../compile/warp-text.js'
import { WarpError } from '../errors/errors.js'
import { checkDefs } from './page/defs.js'
import type { Target } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { readsVariation } from './variation/variation-text.js'
import { hookStyleOf, isOfLines, namesFor, weave } from './hooks/hooks.js'
import { type Canvas, type Shader, pointShaderOf, rendererOf } from './host.js'
import type { WarpSettings } from './settings.js'
import {
  declaredInputs,
  declaredUniforms,
  defsFor,
  frameFor,
  knownTo,
  refuseUndeclared,
} from './sketch-uniforms.js'
import { type WovenType, readsInstance, results, targetOf } from './hooks/styles.js'

export function styleFor(canvas: Canvas) {
  const material = canvas.baseMaterialShader?.()
  const style = material && hookStyleOf(material, targetOf(rendererOf(canvas)!))
  if (!style)
    throw new WarpError('createWarp: this p5 has no shader hooks; version 1.11 or newer is needed.')
  return { material, style }
}

const normalShaderOf = (canvas: Canvas, target: Target) =>
  target === 'wgsl' ? canvas.baseColorShader() : canvas.baseNormalShader()

/** What lines and points are drawn with. */
export interface MovingShaders {
  stroke: Shader
  /** Where points have a shader of their own. */
  point: Shader | undefined
}

export function shadersFor(canvas: Canvas, kept: KeptWarp, settings: WarpSettings) {
  const { material, style } = styleFor(canvas)
  const own = settings.shader
  const renderer = rendererOf(canvas)!
  const target = targetOf(renderer)
  const defs = defsFor(settings, target)
  const weavable = ({ text, parameters }: ReturnType<typeof writeWarp>, base: Shader) => {
    if (target === 'glsl100' && readsInstance(text))
      throw new WarpError('createWarp: the input instance needs WebGL 2 or WebGPU.')
    const declared = declaredUniforms(settings, parameters, target)
    refuseUndeclared(parameters, base, declared, settings, defs, target)
    const { space, hooks } = settings
    return { text, space, defs, hooks, uniforms: [...declaredInputs(text.uniforms), ...declared] }
  }
  const names = namesFor(style)
  const known = knownTo(kept, settings)
  const woven = weavable(writeWarp(kept, target, { names, known }), own ?? material)
  const shaders: Partial<Record<WovenType, Shader>> = {}
  const shaderFor = (type: WovenType): Shader =>
    (shaders[type] ??= weave(
      own ?? (type === 'normal' ? normalShaderOf(canvas, target) : material),
      style,
      woven,
      type,
    ))
  if (defs.trim()) checkDefs(shaderFor(own ? 'own' : (settings.type ?? 'specular')), defs, renderer)
  return {
    renderer,
    inputs: woven.text.uniforms,
    frame: lazily(() => frameFor(kept, known)),
    varies: readsVariation(woven.text),
    shaderFor,
    /** Nothing where the warp reads what lines lack: then they cannot follow the fill. */
    moving: lazily((): MovingShaders | undefined => {
      const written = writeMoves(kept, target, results, { names, known })
      if (!isOfLines(written.text)) return undefined
      const base = canvas.baseStrokeShader()
      const along = weavable(written, base)
      const points = style.point && pointShaderOf(renderer)
      return {
        stroke: base.modify(style.stroke(along, base)),
        // 1.11 asks for it, and has none.
        point:
          points &&
          Object.assign(points.modify(style.point!(along)), { isPointShader: () => true }),
      }
    }),
  }
}
