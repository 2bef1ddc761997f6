/** The shaders of one warp for one renderer, each made on first use. */
import {
  lazily,
  type HostText,
  type HostWarp,
  type NormalStage,
  type Target,
} from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { addWarp, canMoveLines, hookStyleOf, namesFor } from './hooks/hooks.js'
import { obstacleFor, pixelTextOf } from './hooks/pixel-code.js'
import { readsInstance, targetOf, type MaterialKind, type PixelCode } from './hooks/styles.js'
import { pointShaderOf, rendererOf, type Canvas, type Renderer, type Shader } from './host.js'
import { checkDefs } from './page/defs.js'
import type { WarpSettings } from './settings.js'
import { declaredInputs, declaredUniforms, defsFor, rejectUndeclared } from './sketch-uniforms.js'
import { readsVariation } from './variation/variation-text.js'

export function styleFor(canvas: Canvas) {
  const material = canvas.baseMaterialShader?.()
  const style = material && hookStyleOf(material, targetOf(rendererOf(canvas)!))
  if (!style)
    throw new WarpError('createWarp: this p5 has no shader hooks; version 1.11 or newer is needed.')
  return { material, style }
}

const normalShaderOf = (canvas: Canvas, target: Target) =>
  target === 'wgsl' ? canvas.baseColorShader() : canvas.baseNormalShader()

/** The maximum number of varyings that p5's material and our hooks use, besides the inputs of a warp. */
const otherVaryings = 6

function maxVaryingsOf({ GL, device }: Renderer): number {
  const max = GL
    ? GL.getParameter(GL.MAX_VARYING_VECTORS)
    : (device?.limits?.maxInterStageShaderVariables ?? 16)
  return max - otherVaryings
}

const warnAboutVertexNormals = (obstacle: string) =>
  console.warn(
    `createWarp: the normals of this warp are computed at vertices, although its option "normals" is 'pixel': ${obstacle}.`,
  )

/** The shaders that draw warped lines and points. */
export interface StrokeShaders {
  stroke: Shader
  /** Present if points have a shader of their own. */
  point: Shader | undefined
}

export function shadersFor(canvas: Canvas, warp: HostWarp, settings: WarpSettings) {
  const { material, style } = styleFor(canvas)
  const sketchShader = settings.shader
  const renderer = rendererOf(canvas)!
  const target = targetOf(renderer)
  const defs = defsFor(settings, target)
  const uniformsOf = (text: HostText) => [
    ...declaredInputs(text),
    ...declaredUniforms(warp, text, settings, target),
  ]
  const toWarpCode = (text: HostText, base: Shader) => {
    if (target === 'glsl100' && readsInstance(text))
      throw new WarpError('createWarp: the input instance needs WebGL 2 or WebGPU.')
    const uniforms = uniformsOf(text)
    rejectUndeclared(warp, text, base, uniforms, defs, target)
    const { space, hooks } = settings
    return { target, text, space, defs, hooks, uniforms }
  }
  const names = namesFor(style)
  const warpCode = toWarpCode(
    warp.text(target, ['offset', 'position', 'normal'], { names }),
    sketchShader ?? material,
  )
  const pixelText = lazily(() => pixelTextOf(warp, target))
  /** Returns the code for pixels, or why the shader cannot run it. */
  const pixelCodeFor = (base: Shader): PixelCode | string => {
    const code = pixelText()
    const pixel = { ...code, uniforms: uniformsOf(code.text) }
    const isAfter = (hook: string) => style.isAfterWarp(hook, warpCode)
    const maxVaryings = maxVaryingsOf(renderer)
    return obstacleFor(pixel, base, { defs, isAfter, maxVaryings }) ?? pixel
  }
  const shaders: Partial<Record<MaterialKind, Shader>> = {}
  const baseOf = (type: MaterialKind) =>
    sketchShader ?? (type === 'normal' ? normalShaderOf(canvas, target) : material)
  const makeShader = (type: MaterialKind) => {
    const base = baseOf(type)
    const pixel = settings.stage === 'pixel' ? pixelCodeFor(base) : undefined
    if (typeof pixel === 'string') {
      if (settings.normals === 'pixel') warnAboutVertexNormals(pixel)
      return addWarp(base, style, warpCode, type)
    }
    return addWarp(base, style, { ...warpCode, pixel }, type)
  }
  const shaderFor = (type: MaterialKind): Shader => (shaders[type] ??= makeShader(type))
  const defaultType = sketchShader ? 'own' : (settings.type ?? 'specular')
  if (defs.trim()) checkDefs(shaderFor(defaultType), defs, renderer)
  return {
    renderer,
    inputs: warpCode.text.uniforms,
    readsVariation: readsVariation(warpCode.text),
    shaderFor,
    /** Returns the stage in which the shader of the option `shader`, or of p5's material, computes normals. */
    stageOfNormals: lazily((): NormalStage => {
      const isPixel =
        settings.stage === 'pixel' && typeof pixelCodeFor(baseOf(defaultType)) === 'object'
      return isPixel ? 'pixel' : 'vertex'
    }),
    /** Returns `undefined` if the warp reads inputs that lines lack: then they cannot follow the fill. */
    strokeShaders: lazily((): StrokeShaders | undefined => {
      const text = warp.text(target, ['position', 'jacobian'], { names })
      if (!canMoveLines(text)) return undefined
      const base = canvas.baseStrokeShader()
      const lineCode = toWarpCode(text, base)
      const points = style.hooksForPoints && pointShaderOf(renderer)
      return {
        stroke: base.modify(style.hooksForStrokes(lineCode, base)),
        // p5 1.11 calls isPointShader, but does not define it.
        point:
          points &&
          Object.assign(points.modify(style.hooksForPoints!(lineCode)), {
            isPointShader: () => true,
          }),
      }
    }),
  }
}
