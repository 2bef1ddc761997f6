/** `createWarp`: calls the offset function once, and returns the function that a sketch calls to draw with the warp. */
import {
  HostWarp,
  type NormalStage,
  type OffsetFunction,
  type UniformOverrides,
} from '../compile/hosts.js'
import { onlyOnGpu, warnOfDetail } from '../detail/warnings.js'
import { isExpression } from '../errors/describe.js'
import { WarpError, describe } from '../errors/errors.js'
import { markLibraryFunction, operatorsKey, translateOperators } from '../errors/operators.js'
import { callback } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { useDetail } from './detail/detail.js'
import { bakeIntoGeometry } from './geometry/bake.js'
import { namesFor } from './hooks/hooks.js'
import { targetOf } from './hooks/styles.js'
import {
  drawsNormals,
  rememberNormals,
  rendererOf,
  sketchOf,
  stateOf,
  type Canvas,
  type Shader,
} from './host.js'
import { rememberWarp } from './made-warps.js'
import { checkShader, copyUniforms } from './own-shader.js'
import { withGuards } from './page/guards.js'
import { withSketchLine } from './page/places.js'
import { readOptions, type CreateWarpOptions, type OptionsWithDefaults } from './settings.js'
import { shadersFor, styleFor } from './shaders.js'
import { p5, setInputs, setUniforms, valuesOf, type WarpUniforms } from './sketch-uniforms.js'
import { applyStrokeShaders } from './strokes.js'
import { prepareBuffers } from './variation/variation-buffers.js'

const place = new Place('createWarp')

/**
 * Applies the warp to the shapes drawn next: to fills, and to strokes as the option `stroke` says. The argument overrides values of
 * the option `uniforms` for this call only; uniforms that `defs` declares keep the values set here.
 */
export interface Distort<Uniforms = {}> {
  (uniforms?: UniformOverrides<Uniforms> & WarpUniforms): void
  /**
   * The stage that computes normals: the option `normals`, with `'auto'` resolved for this warp. `'vertex'` if the shader cannot compute
   * normals at pixels.
   */
  readonly normals: NormalStage
}

/** Maps a shader in use to a function that applies its warp again, after the sketch changed the material. */
const reapply = new WeakMap<Shader, () => void>()

export const createWarp = (
  canvas: Canvas,
  offset: OffsetFunction,
  options?: CreateWarpOptions,
): Distort => {
  warnIfMadeInDraw(sketchOf(canvas))
  return withSketchLine(() => create(canvas, offset, options))
}

/** Maps a sketch to the last frame in which it made a warp, and the number of consecutive frames before that in which it also made one. */
const recentWarps = new WeakMap<Canvas, readonly [frame: number, streak: number]>()

/** Warns once if the sketch makes a warp in several consecutive frames. */
function warnIfMadeInDraw(sketch: Canvas) {
  const frame = sketch.frameCount ?? 0
  const [lastFrame, lastStreak] = recentWarps.get(sketch) ?? [frame, 0]
  if (lastStreak > 2) return
  const streak = frame === lastFrame ? lastStreak : frame === lastFrame + 1 ? lastStreak + 1 : 0
  recentWarps.set(sketch, [frame, streak])
  if (streak > 2)
    console.warn(
      'createWarp: each call makes a new shader, which is slow in every frame; call it once, in setup(), and in draw() call the function that it returned.',
    )
}

function create(canvas: Canvas, userOffset: OffsetFunction, options?: CreateWarpOptions): Distort {
  const allOptions = readOptions(options)
  const offset = offsetFor(canvas, userOffset, allOptions)
  if (!rendererOf(canvas))
    throw new WarpError(
      canvas._renderer?.isP3D
        ? `createWarp: this WEBGPU canvas is not ready yet; ${
            sketchOf(canvas) === canvas
              ? 'write "await createCanvas(width, height, WEBGPU)" in an "async function setup()"'
              : 'make a p5.Graphics by createGraphics(width, height, WEBGL)'
          }.`
        : 'createWarp: a warp needs a 3D canvas; call createCanvas(width, height, WEBGL) first.',
    )
  const warp = warpFor(canvas, offset, allOptions)
  const settings = { ...allOptions, stage: warp.stageOfNormals(allOptions.normals) }
  let shaders = shadersFor(canvas, warp, settings)

  function apply(uniforms: WarpUniforms) {
    const renderer = rendererOf(canvas)
    if (!renderer) throw new WarpError('The canvas that this warp was made for is gone.')
    // setAttributes() and a second createCanvas() make a new renderer, which cannot use the shaders of the old one.
    if (renderer !== shaders.renderer) shaders = shadersFor(canvas, warp, settings)

    const showsNormals = drawsNormals(renderer)
    const shader = shaders.shaderFor(
      settings.shader ? 'own' : (settings.type ?? (showsNormals ? 'normal' : 'specular')),
    )
    if (shaders.readsVariation) prepareBuffers(renderer)
    canvas.shader(shader)
    if (showsNormals) rememberNormals(renderer, shader)
    copyUniforms(settings, shader)
    const values = valuesOf(canvas, uniforms, warp)
    const frame = warp.frame(values)
    for (const each of [shader, ...applyStrokeShaders(canvas, settings, shaders.strokeShaders)]) {
      setInputs(each, shaders.inputs, canvas, frame)
      setUniforms(each, uniforms, warp, settings, values)
    }
    if (settings.detail && !warp.canRunOnCpu)
      warnOfDetail(warp, 'createWarp', 'each shape', onlyOnGpu)
    else if (settings.detail)
      useDetail(renderer, shader, {
        canvas,
        warp,
        space: settings.space,
        ...settings.detail,
        values,
      })
    reapply.set(shader, () => apply(uniforms))
    bakeIntoGeometry({ canvas, warp, settings }, shader, uniforms, values)
  }

  const distort = (uniforms: WarpUniforms = {}) =>
    withSketchLine(() => {
      if (uniforms === null || typeof uniforms !== 'object' || Array.isArray(uniforms))
        throw new WarpError(
          `The function that createWarp returned: expected an object of uniforms, such as { size: 0.5 }, got ${describe(uniforms)}.`,
        )
      apply(uniforms)
    })
  Object.defineProperty(distort, 'normals', {
    get: () => shaders.stageOfNormals(),
    enumerable: true,
  })
  return rememberWarp(distort as Distort, { canvas, warp, settings })
}

/** Returns the offset function with its operators translated, and with p5's number functions guarded while it runs. */
function offsetFor(
  canvas: Canvas,
  userOffset: OffsetFunction,
  { returns, scope }: OptionsWithDefaults,
): OffsetFunction {
  callback.read(userOffset, place)
  if (scope && !(operatorsKey in globalThis))
    throw new WarpError(
      'createWarp: the option "scope" is for functions with operators; add the script warpjet.operators.min.js, or import \'warpjet/operators\'.',
    )
  const readable = translateOperators(userOffset, {
    method: 'createWarp',
    scope,
    sketch: sketchOf(canvas),
  })
  const offset = withGuards(canvas, readable)
  return markLibraryFunction((inputs) => {
    const result = offset(inputs)
    return returns === 'position' && isExpression(result) ? result.sub(inputs.position) : result
  })
}

/** Calls the offset function, once for all shaders. */
function warpFor(canvas: Canvas, offset: OffsetFunction, settings: OptionsWithDefaults): HostWarp {
  const { style } = styleFor(canvas)
  checkShader(settings, style, rendererOf(canvas)!)
  return new HostWarp(place, offset, {
    host: p5,
    uniforms: settings.uniforms,
    target: targetOf(rendererOf(canvas)!),
    names: namesFor(style),
    fadeNoise: settings.fadeNoise,
    surfaceVariation: settings.surfaceVariation ?? true,
    jacobian: settings.stroke !== false,
  })
}

/** Tests whether the canvas draws its next shape with a warp. */
export function isWarped(canvas: Canvas): boolean {
  const renderer = rendererOf(canvas)
  const shader = renderer && stateOf(renderer).userFillShader
  return !!shader && reapply.has(shader)
}

/**
 * Applies the current warp again, after the sketch called `normalMaterial()` or `stroke()`. Otherwise `normalMaterial()` would
 * drop the warp on p5 1.11 and have no effect on 2.x.
 */
export function reapplyWarp(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  const shader = renderer && stateOf(renderer).userFillShader
  if (shader) reapply.get(shader)?.()
}
