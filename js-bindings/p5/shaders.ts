/** The shaders of one warp for one renderer: each is made when it is first drawn with. */
import { type HostText, type HostWarp, type Target, lazily } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { checkDefs } from './page/defs.js'
import { readsVariation } from './variation/variation-text.js'
import { hookStyleOf, isOfLines, namesFor, weave } from './hooks/hooks.js'
import { type Canvas, type Shader, pointShaderOf, rendererOf } from './host.js'
import type { WarpSettings } from './settings.js'
import { declaredInputs, declaredUniforms, defsFor, refuseUndeclared } from './sketch-uniforms.js'
import { type WovenType, readsInstance, targetOf } from './hooks/styles.js'

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

export function shadersFor(canvas: Canvas, warp: HostWarp, settings: WarpSettings) {
  const { material, style } = styleFor(canvas)
  const own = settings.shader
  const renderer = rendererOf(canvas)!
  const target = targetOf(renderer)
  const defs = defsFor(settings, target)
  const weavable = (text: HostText, base: Shader) => {
    if (target === 'glsl100' && readsInstance(text))
      throw new WarpError('createWarp: the input instance needs WebGL 2 or WebGPU.')
    const declared = declaredUniforms(warp, text, settings, target)
    refuseUndeclared(warp, text, base, declared, defs, target)
    const { space, hooks } = settings
    return { text, space, defs, hooks, uniforms: [...declaredInputs(text), ...declared] }
  }
  const names = namesFor(style)
  const woven = weavable(
    warp.text(target, ['offset', 'position', 'normal'], { names }),
    own ?? material,
  )
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
    varies: readsVariation(woven.text),
    shaderFor,
    /** Nothing where the warp reads what lines lack: then they cannot follow the fill. */
    moving: lazily((): MovingShaders | undefined => {
      const text = warp.text(target, ['position', 'jacobian'], { names })
      if (!isOfLines(text)) return undefined
      const base = canvas.baseStrokeShader()
      const along = weavable(text, base)
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
