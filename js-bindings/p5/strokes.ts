/**
 * Lines and points follow the fill if the option `stroke` is true or, by default, if the sketch itself called `stroke()`: sketches
 * that never call it were written for warps without lines.
 */
import { WarpError } from '../errors/errors.js'
import { rendererOf, setState, stateOf, type Canvas, type Renderer, type Shader } from './host.js'
import type { WarpSettings } from './settings.js'
import type { StrokeShaders } from './shaders.js'

/** The renderers for which `stroke()` was called, and the colour objects that it made: p5 makes a new one in each call. */
const requested = new WeakSet<object>()

/** Records that the sketch has called `stroke()`. */
export function recordStrokeCall(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  if (renderer) requested.add(renderer).add(colorOf(renderer))
}

const colorOf = (renderer: Renderer) => stateOf(renderer).curStrokeColor as readonly number[]

/** Returns whether the sketch set the current stroke colour. p5's initial one is black; p5 copies others, in `bezierVertex` for instance. */
const hasSketchStroke = (renderer: Renderer) =>
  requested.has(colorOf(renderer)) ||
  (requested.has(renderer) && `${colorOf(renderer)}` !== '0,0,0,1')

/** Returns whether p5 draws lines. If not, 2.x has no colour for them, and 1.11 has a flag. */
const areLinesVisible = (renderer: Renderer) =>
  renderer.states ? !!renderer.states.strokeColor : !!renderer._doStroke

/** Our shaders of lines and points, which p5 keeps even when another fill shader replaces ours. */
const ours = new WeakSet<Shader>()

/** Applies a warp's shaders of lines and points, or turns strokes off. Returns the shaders now in use. */
export function applyStrokeShaders(
  canvas: Canvas,
  { stroke, shader }: WarpSettings,
  strokeShaders: () => StrokeShaders | undefined,
): Shader[] {
  const renderer = rendererOf(canvas)!
  const hasVertexHooks = Object.keys(shader?.hooks.modified.vertex ?? {}).length > 0
  const isWanted = stroke ?? (hasSketchStroke(renderer) && !hasVertexHooks)
  if (!isWanted) {
    canvas.noStroke()
    return []
  }
  if (!areLinesVisible(renderer)) return []
  const shaders = strokeShaders()
  if (!shaders) {
    if (stroke)
      throw new WarpError(
        'createWarp: lines have no normal, uv or fill, so this offset cannot move them; leave the option "stroke" out, or make the offset depend on position alone.',
      )
    canvas.noStroke()
    return []
  }
  if (canvas.strokeShader) canvas.strokeShader(shaders.stroke)
  else applyOnV1(canvas, renderer, 'userStrokeShader', shaders.stroke)
  if (shaders.point) applyOnV1(canvas, renderer, 'userPointShader', shaders.point)
  const used = [shaders.stroke, ...(shaders.point ? [shaders.point] : [])]
  for (const shader of used) ours.add(shader)
  return used
}

/** Applies a shader of lines or points on 1.11, in the same way as its `shader()`. */
function applyOnV1(
  canvas: Canvas,
  renderer: Renderer,
  name: 'userStrokeShader' | 'userPointShader',
  shader: Shader,
) {
  shader.ensureCompiledOnContext!(canvas)
  setState(renderer, name, shader)
}

export const isStrokeShader = (shader: Shader | null | undefined) => !!shader && ours.has(shader)

/** Returns whether our shader draws the lines of the next shape. */
export const drawsWarpedLines = (renderer: Renderer) =>
  areLinesVisible(renderer) && isStrokeShader(stateOf(renderer).userStrokeShader)

/** Returns whether our shaders draw lines and points already. */
export const hasStrokes = (canvas: Canvas) =>
  isStrokeShader(stateOf(rendererOf(canvas)!).userStrokeShader)

/** Removes our shaders of lines and points too, after the sketch has applied another fill shader. */
export function dropStrokes(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  if (!renderer) return
  for (const name of ['userStrokeShader', 'userPointShader'] as const)
    if (ours.has(stateOf(renderer)[name] ?? ({} as Shader))) setState(renderer, name, undefined)
}
