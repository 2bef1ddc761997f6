/**
 * Lines and points follow the fill where the option `stroke` says so, or, left out, where the sketch itself called `stroke()`:
 * sketches that never did were written for warps without lines.
 */
import { WarpError } from '../errors/errors.js'
import { type Canvas, type Renderer, type Shader, rendererOf, setState, stateOf } from './host.js'
import type { WarpSettings } from './settings.js'
import type { MovingShaders } from './shaders.js'

/** The colours that `stroke()` made, since p5 has a new one for each call; and the renderers that it was called for. */
const asked = new WeakSet<object>()

/** To be called when the sketch has called `stroke()`. */
export function strokeWasCalled(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  if (renderer) asked.add(renderer).add(colorOf(renderer))
}

const colorOf = (renderer: Renderer) => stateOf(renderer).curStrokeColor as readonly number[]

/** Black is what p5 begins with. Other colours are copied at times, by `bezierVertex` for one. */
const isAsked = (renderer: Renderer) =>
  asked.has(colorOf(renderer)) || (asked.has(renderer) && `${colorOf(renderer)}` !== '0,0,0,1')

/** Whether lines are to be seen, in p5 2.x by their colour. */
const areSeen = (renderer: Renderer) =>
  renderer.states ? !!renderer.states.strokeColor : !!renderer._doStroke

/** Our shaders of lines and points, which p5 keeps where another shader of fills takes the place of ours. */
const ours = new WeakSet<Shader>()

/** Puts a warp's lines and points on, or turns them off; gives the shaders that are now in use. */
export function putOnStrokes(
  canvas: Canvas,
  { stroke, shader }: WarpSettings,
  moving: () => MovingShaders | undefined,
): Shader[] {
  const renderer = rendererOf(canvas)!
  const isMovedBeside = Object.keys(shader?.hooks.modified.vertex ?? {}).length > 0
  const isWanted = stroke ?? (isAsked(renderer) && !isMovedBeside)
  if (!isWanted) {
    canvas.noStroke()
    return []
  }
  if (!areSeen(renderer)) return []
  const shaders = moving()
  if (!shaders) {
    if (stroke)
      throw new WarpError(
        'createWarp: lines have no normal, uv or fill, so that this offset cannot move them; leave the option "stroke" out, or write the offset with position alone.',
      )
    canvas.noStroke()
    return []
  }
  if (canvas.strokeShader) canvas.strokeShader(shaders.stroke)
  else putOn(canvas, renderer, 'userStrokeShader', shaders.stroke)
  if (shaders.point) putOn(canvas, renderer, 'userPointShader', shaders.point)
  const used = [shaders.stroke, ...(shaders.point ? [shaders.point] : [])]
  for (const shader of used) ours.add(shader)
  return used
}

/** On 1.11, as its `shader` does. */
function putOn(
  canvas: Canvas,
  renderer: Renderer,
  name: 'userStrokeShader' | 'userPointShader',
  shader: Shader,
) {
  shader.ensureCompiledOnContext!(canvas)
  setState(renderer, name, shader)
}

/** Whether lines and points are ours already. */
export const hasStrokes = (canvas: Canvas) =>
  ours.has(stateOf(rendererOf(canvas)!).userStrokeShader ?? ({} as Shader))

/** When the sketch puts another shader on, the warp is over, for lines too. */
export function dropStrokes(canvas: Canvas) {
  const renderer = rendererOf(canvas)
  if (!renderer) return
  for (const name of ['userStrokeShader', 'userPointShader'] as const)
    if (ours.has(stateOf(renderer)[name] ?? ({} as Shader))) setState(renderer, name, undefined)
}
