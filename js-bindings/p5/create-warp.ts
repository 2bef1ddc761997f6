/** `createWarp` itself: calls the offset function once, and makes the function that a sketch calls to draw with the warp. */
import {
  type KeptWarp,
  keepWarp,
  readOptions as readWarpOptions,
  writeWarp,
} from '../compile/warp-text.js'
import { WarpError, describe } from '../checks/errors.js'
import { noteApproximation } from '../checks/notes.js'
import { hookStyleOf, namesFor, results, weave } from './hooks.js'
import {
  type Canvas,
  type Shader,
  drawsNormals,
  materialOf,
  rememberNormals,
  webglOf,
} from './host.js'
import {
  type CreateWarpOptions,
  type WarpSettings,
  type WarpType,
  readOptions,
} from './settings.js'
import { checkCallback } from '../checks/options.js'
import type { OffsetFunction, UniformOverrides } from '../types/types.js'
import { withUniforms } from '../inputs/declared-uniforms.js'
import {
  type WarpUniforms,
  declarationsOf,
  labelsOf,
  refuseUndeclared,
  setInputs,
  setUniforms,
} from './sketch-uniforms.js'
import { noteUnlessUsed, readsVariation } from './add-surface-variation.js'

/**
 * Puts the warp on what is drawn next, and turns strokes off, which p5 would draw unwarped. Values of the option `uniforms`
 * may be replaced, for this call alone; those that `defs` declares keep what they are set to.
 */
export type Distort<Uniforms = {}> = (uniforms?: UniformOverrides<Uniforms> & WarpUniforms) => void

/** For a shader that is in use: puts its warp on again, after the sketch changed the material. */
const reapply = new WeakMap<Shader, () => void>()

export function createWarp(
  canvas: Canvas,
  given: OffsetFunction,
  options?: CreateWarpOptions,
): Distort {
  const settings = readOptions(options)
  const offset = offsetFor(given, settings)
  if (!webglOf(canvas))
    throw new WarpError(
      'createWarp: a warp needs a 3D canvas, made before it by createCanvas(width, height, WEBGL).',
    )
  const warp = keepFor(canvas, offset, settings)
  let written = writeFor(canvas, warp, settings)

  function apply(uniforms: WarpUniforms) {
    const renderer = webglOf(canvas)
    if (!renderer) throw new WarpError('The canvas that this warp was made for is gone.')
    // setAttributes() and a second createCanvas() make a new renderer, where the old one's shaders mean nothing.
    if (renderer !== written.renderer) written = writeFor(canvas, warp, settings)

    const isNormal = drawsNormals(renderer)
    const shader = written.shaderFor(settings.type ?? (isNormal ? 'normal' : 'specular'))
    if (written.varies && settings.surfaceVariation === undefined) noteUnlessUsed()
    canvas.shader(shader)
    if (isNormal) rememberNormals(renderer, shader)
    canvas.noStroke()
    setInputs(shader, written.inputs, canvas)
    setUniforms(shader, uniforms, settings)
    reapply.set(shader, () => apply(uniforms))
  }

  return (uniforms = {}) => {
    if (uniforms === null || typeof uniforms !== 'object' || Array.isArray(uniforms))
      throw new WarpError(
        `The function that createWarp returned takes an object of uniforms, such as { size: 0.5 }, but ${describe(uniforms)} came.`,
      )
    apply(uniforms)
  }
}

/** It reads its uniforms by the names that they have in the shader. */
function offsetFor(given: OffsetFunction, { uniforms }: WarpSettings): OffsetFunction {
  checkCallback('createWarp', given)
  const labels = labelsOf(uniforms)
  return withUniforms('createWarp', given, uniforms, (name) => labels.get(name)!)
}

function styleFor(canvas: Canvas) {
  const material = canvas.baseMaterialShader?.()
  const style = material && hookStyleOf(material)
  if (!style)
    throw new WarpError('createWarp: this p5 has no shader hooks; version 1.11 or newer is needed.')
  return { material, style }
}

const targetFor = (canvas: Canvas) =>
  webglOf(canvas)?.webglVersion === 'webgl' ? 'glsl100' : 'glsl300'

/** Calls the offset function, for all shaders that will ever be written. */
function keepFor(
  canvas: Canvas,
  offset: OffsetFunction,
  { surfaceVariation }: WarpSettings,
): KeptWarp {
  const { style } = styleFor(canvas)
  if (surfaceVariation && !style.hasVariation)
    throw new WarpError('createWarp: surfaceVariation needs p5 2; leave it out.')
  const warp = keepWarp(
    offset,
    readWarpOptions('createWarp', offset, {
      target: targetFor(canvas),
      names: namesFor(style),
      outputs: results,
      surfaceVariation: surfaceVariation ?? (style.hasVariation || undefined),
    }),
  )
  if (warp.isApproximate) noteApproximation('createWarp', 'addSurfaceVariation(shape) on p5 2')
  return warp
}

/** The warp as shaders of the canvas's present renderer, one for each material, made when it is first drawn with. */
function writeFor(canvas: Canvas, kept: KeptWarp, settings: WarpSettings) {
  const { material, style } = styleFor(canvas)
  const { text: warp, parameters } = writeWarp(kept, targetFor(canvas))
  const woven = { ...settings, defs: declarationsOf(settings.uniforms, parameters) + settings.defs }
  refuseUndeclared(parameters, material, woven)
  const shaders: Partial<Record<WarpType, Shader>> = {}
  return {
    renderer: webglOf(canvas),
    inputs: warp.uniforms,
    varies: readsVariation(warp),
    shaderFor: (type: WarpType) =>
      (shaders[type] ??= weave(
        type === 'normal' ? canvas.baseNormalShader() : material,
        style,
        warp,
        woven,
        type,
      )),
  }
}

/**
 * Called after the sketch's `normalMaterial()`, for which p5 1.11 would drop the warp and 2.x would ignore the material.
 */
export function putOnAgain(canvas: Canvas) {
  const renderer = webglOf(canvas)
  const shader = renderer && materialOf(renderer).userFillShader
  if (shader) reapply.get(shader)?.()
}
