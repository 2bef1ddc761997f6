/** `createWarp` itself: calls the offset function once, and makes the function that a sketch calls to draw with the warp. */
import { HostWarp, type OffsetFunction, type UniformOverrides } from '../compile/hosts.js'
import { isExpression } from '../errors/describe.js'
import { WarpError, describe } from '../errors/errors.js'
import { asOwn, operatorsKey, readOperators } from '../errors/operators.js'
import { callback } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { bakeIntoGeometry } from './geometry/bake.js'
import { guarded } from './page/guards.js'
import { namesFor } from './hooks/hooks.js'
import { rememberWarp } from './made-warps.js'
import { located } from './page/places.js'
import {
  type Canvas,
  type Shader,
  drawsNormals,
  rememberNormals,
  rendererOf,
  sketchOf,
  stateOf,
} from './host.js'
import { type CreateWarpOptions, type WarpSettings, readOptions } from './settings.js'
import { checkShader, passOn } from './own-shader.js'
import { shadersFor, styleFor } from './shaders.js'
import { putOnStrokes } from './strokes.js'
import { targetOf } from './hooks/styles.js'
import { type WarpUniforms, p5, setInputs, setUniforms, valuesOf } from './sketch-uniforms.js'
import { prepareBuffers } from './variation/variation-buffers.js'

const place = new Place('createWarp')

/**
 * Puts the warp on what is drawn next: fills, and strokes as the option `stroke` says. Values of the option `uniforms` may be
 * replaced, for this call alone; those that `defs` declares keep what they are set to.
 */
export type Distort<Uniforms = {}> = (uniforms?: UniformOverrides<Uniforms> & WarpUniforms) => void

/** For a shader that is in use: puts its warp on again, after the sketch changed the material. */
const reapply = new WeakMap<Shader, () => void>()

export const createWarp = (
  canvas: Canvas,
  offset: OffsetFunction,
  options?: CreateWarpOptions,
): Distort => {
  noteInDraw(sketchOf(canvas))
  return located(() => create(canvas, offset, options))
}

/** By sketch, the last frame in which it made a warp, and how many before it did so in a row. */
const making = new WeakMap<Canvas, readonly [frame: number, row: number]>()

/** Said once, where a warp was made in each of three frames. */
function noteInDraw(sketch: Canvas) {
  const frame = sketch.frameCount ?? 0
  const [last, row] = making.get(sketch) ?? [frame, 0]
  if (row > 2) return
  const now = frame === last ? row : frame === last + 1 ? row + 1 : 0
  making.set(sketch, [frame, now])
  if (now > 2)
    console.warn(
      'createWarp: it makes a new shader in every frame, which is slow; call it once, in setup(), and in draw() the function that it returned.',
    )
}

function create(canvas: Canvas, given: OffsetFunction, options?: CreateWarpOptions): Distort {
  const settings = readOptions(options)
  const offset = offsetFor(canvas, given, settings)
  if (!rendererOf(canvas))
    throw new WarpError(
      canvas._renderer?.isP3D
        ? `createWarp: this WEBGPU canvas is not ready yet; ${
            sketchOf(canvas) === canvas
              ? 'write "await createCanvas(width, height, WEBGPU)" in an "async function setup()"'
              : 'make a p5.Graphics by createGraphics(width, height, WEBGL)'
          }.`
        : 'createWarp: a warp needs a 3D canvas, made before it by createCanvas(width, height, WEBGL).',
    )
  const warp = warpFor(canvas, offset, settings)
  let written = shadersFor(canvas, warp, settings)

  function apply(uniforms: WarpUniforms) {
    const renderer = rendererOf(canvas)
    if (!renderer) throw new WarpError('The canvas that this warp was made for is gone.')
    // setAttributes() and a second createCanvas() make a new renderer, where the old one's shaders mean nothing.
    if (renderer !== written.renderer) written = shadersFor(canvas, warp, settings)

    const isNormal = drawsNormals(renderer)
    const shader = written.shaderFor(
      settings.shader ? 'own' : (settings.type ?? (isNormal ? 'normal' : 'specular')),
    )
    if (written.varies) prepareBuffers(renderer)
    canvas.shader(shader)
    if (isNormal) rememberNormals(renderer, shader)
    passOn(settings, shader)
    const values = valuesOf(canvas, uniforms, warp)
    const frame = warp.frame(values)
    for (const each of [shader, ...putOnStrokes(canvas, settings, written.moving)]) {
      setInputs(each, written.inputs, canvas, frame)
      setUniforms(each, uniforms, warp, settings, values)
    }
    reapply.set(shader, () => apply(uniforms))
    bakeIntoGeometry({ canvas, warp, settings }, shader, uniforms, values)
  }

  const distort: Distort = (uniforms = {}) =>
    located(() => {
      if (uniforms === null || typeof uniforms !== 'object' || Array.isArray(uniforms))
        throw new WarpError(
          `The function that createWarp returned takes an object of uniforms, such as { size: 0.5 }, but ${describe(uniforms)} came.`,
        )
      apply(uniforms)
    })
  return rememberWarp(distort, { canvas, warp, settings })
}

/** The offset function with its operators read, guarded while it runs. */
function offsetFor(
  canvas: Canvas,
  given: OffsetFunction,
  { returns, scope }: WarpSettings,
): OffsetFunction {
  callback.read(given, place)
  if (scope && !(operatorsKey in globalThis))
    throw new WarpError(
      'createWarp: the option "scope" is for functions with operators; add the script warpjet.operators.min.js, or import \'warpjet/operators\'.',
    )
  const readable = readOperators(given, { method: 'createWarp', scope, sketch: sketchOf(canvas) })
  const offset = guarded(canvas, readable)
  return asOwn((inputs) => {
    const result = offset(inputs)
    return returns === 'position' && isExpression(result) ? result.sub(inputs.position) : result
  })
}

/** Calls the offset function, for all shaders that will ever be written. */
function warpFor(canvas: Canvas, offset: OffsetFunction, settings: WarpSettings): HostWarp {
  const { style } = styleFor(canvas)
  checkShader(settings, style, rendererOf(canvas)!)
  return new HostWarp(place, offset, {
    host: p5,
    uniforms: settings.uniforms,
    target: targetOf(rendererOf(canvas)!),
    names: namesFor(style),
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
 * Called after the sketch's `normalMaterial()`, for which p5 1.11 would drop the warp and 2.x would ignore the material, and
 * after its `stroke()`.
 */
export function putOnAgain(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  const shader = renderer && stateOf(renderer).userFillShader
  if (shader) reapply.get(shader)?.()
}
