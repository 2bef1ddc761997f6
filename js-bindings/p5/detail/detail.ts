/**
 * The option `detail` of `createWarp`: while a warp's shader is in use, p5 draws shapes with as many triangles as their warped surface
 * needs on the screen. p5 draws a stand-in for the shape, whose buffers are written here; its shaders stay as they are.
 */
import { warnOfDetail } from '../../detail/warnings.js'
import { immediateShape, stateOf, type Renderer, type Shader } from '../host.js'
import { isStrokeShader } from '../strokes.js'
import { uploadLines, type ShapeBuffers } from './buffers.js'
import { divide, freeDraws, type DetailOfWarp, type Divided, type Division } from './draws.js'
import { drawIndirectly } from './indirect.js'
import { divideLines, linesOf } from './lines.js'
import type { DrawnShape } from './shape.js'

const details = new WeakMap<Shader, DetailOfWarp>()

/** Draws shapes with detail while this shader is in use. */
export function useDetail(renderer: Renderer, shader: Shader, detail: DetailOfWarp) {
  if (!shadersOf.has(renderer)) {
    shadersOf.set(renderer, [])
    const drawing = renderer as unknown as Drawing
    if (drawing._drawGeometry) hookDrawGeometry(renderer, drawing as never)
    else hookDrawBuffers(renderer, drawing as never)
  }
  if (!details.has(shader)) shadersOf.get(renderer)!.push(new WeakRef(shader))
  details.set(shader, detail)
}

/** Maps a renderer whose methods are replaced → its shaders with detail. */
const shadersOf = new WeakMap<Renderer, WeakRef<Shader>[]>()

type Draw = (shape: DrawnShape, options?: { mode?: unknown; count?: number }) => void
type DrawBuffers = (name: string) => unknown

interface Drawing {
  /** 2.x only: calls the next two. */
  _drawGeometry?: Draw
  _drawFills?: Draw
  _drawStrokes?: Draw
  readonly geometryBufferCache?: BufferCache
  /** 1.11 only. The next two draw shapes between beginShape() and endShape(). */
  drawBuffers?: DrawBuffers
  _drawImmediateFill?: (count?: number) => void
  _drawImmediateStroke?: () => void
}

interface BufferCache {
  readonly cache: Record<string, ShapeBuffers>
  /** Frees the buffers of the shape with this name. */
  freeBuffers(name: string): void
}

function hookDrawGeometry(renderer: Renderer, drawing: Required<Drawing>) {
  const { _drawGeometry, _drawFills, _drawStrokes, geometryBufferCache } = drawing
  const { cache, freeBuffers } = geometryBufferCache
  /** The division of the shape that is drawn now, which its fill and its strokes share; `undefined` before either is drawn. */
  let current: { readonly division: Division | undefined } | undefined
  const drawDivided = (draw: Draw, shape: DrawnShape, options: Parameters<Draw>[1]) => {
    const obstacle = obstacleOf(shape, options?.count)
    if (obstacle) {
      warnIfRequested(renderer, draw === _drawStrokes, obstacle)
      return draw.call(renderer, shape, options)
    }
    current ??= { division: divideNow(renderer, shape) }
    const { division } = current
    if (!division || (draw === _drawStrokes && !divideStrokes(renderer, shape, division.divided)))
      return draw.call(renderer, shape, options)
    const { buffers, drawn } = division
    const { standIn } = division.divided
    const drawStandIn = () => draw.call(renderer, standIn, options)
    cache[standIn.gid!] = buffers
    try {
      if (drawn) drawIndirectly(renderer, drawn, drawStandIn)
      else drawStandIn()
    } finally {
      delete cache[standIn.gid!]
    }
  }
  drawing._drawGeometry = (shape, options) => {
    current = undefined
    _drawGeometry.call(renderer, shape, options)
  }
  drawing._drawFills = (shape, options) => drawDivided(_drawFills, shape, options)
  drawing._drawStrokes = (shape, options) => drawDivided(_drawStrokes, shape, options)
  geometryBufferCache.freeBuffers = (name) => {
    const shape = cache[name]?.geometry as DrawnShape | undefined
    for (const each of shape ? shadersOf.get(renderer)! : []) {
      const shader = each.deref()
      if (shader) freeDraws(renderer, shader, shape!)
    }
    freeBuffers.call(geometryBufferCache, name)
  }
}

/** On 1.11, renderers map a shape's name to an object with its buffers, whose property `model` is the shape. */
function hookDrawBuffers(renderer: Renderer, drawing: Required<Drawing>) {
  const { drawBuffers: draw, _drawImmediateFill, _drawImmediateStroke } = drawing
  drawing._drawImmediateFill = (count) => {
    warnIfRequested(renderer, false, immediateObstacle)
    _drawImmediateFill.call(renderer, count)
  }
  drawing._drawImmediateStroke = () => {
    warnIfRequested(renderer, true, immediateObstacle)
    _drawImmediateStroke.call(renderer)
  }
  const shapes = renderer.retainedMode!.geometry as Record<string, ShapeBuffers>
  drawing.drawBuffers = function (name) {
    const before = shapes[name]!
    // A GeometryBuilder collects shapes, and draws none.
    const isDrawn = before && !renderer.geometryBuilder
    const shape = before?.model as DrawnShape
    const obstacle = isDrawn && obstacleOf(shape)
    if (obstacle) warnIfRequested(renderer, !shape.faces?.length, obstacle)
    const division = isDrawn && !obstacle ? divideNow(renderer, shape) : undefined
    if (!division) return draw.call(this, name)
    const { divided, buffers } = division
    const { standIn } = divided
    shapes[name] = Object.assign(Object.create(before), buffers, {
      model: standIn,
      vertexCount: 3 * standIn.faces.length,
      ...(divideStrokes(renderer, shape, divided) && {
        lineVertexCount: (standIn.lineVertices as ArrayLike<number>).length / 3,
      }),
    })
    try {
      return draw.call(this, name)
    } finally {
      shapes[name] = before
    }
  }
}

const immediateObstacle = 'lines, and shapes between beginShape() and endShape(), are not divided'

/** Describes why a shape is drawn with its own vertices; `undefined` if it is divided. */
function obstacleOf({ gid, faces }: DrawnShape, instances = 1): string | undefined {
  if (gid === immediateShape || !faces?.length) return immediateObstacle
  return instances > 1 ? 'instances are not divided' : undefined
}

/** Warns that the shape that is drawn now is not divided, if the present shader asks for detail, and for strokes, if it moves them. */
function warnIfRequested(renderer: Renderer, isStroke: boolean, obstacle: string) {
  const { userFillShader, userStrokeShader } = stateOf(renderer)
  const detail = userFillShader && details.get(userFillShader)
  if (detail && (!isStroke || isStrokeShader(userStrokeShader)))
    warnOfDetail(detail.warp, 'createWarp', 'a shape', obstacle)
}

/** Divides a shape for a draw with the present shader. Returns `undefined` if the shape is not divided. */
function divideNow(renderer: Renderer, shape: DrawnShape): Division | undefined {
  const shader = stateOf(renderer).userFillShader
  const detail = shader && details.get(shader)
  return detail ? divide(renderer, shader, shape, detail) : undefined
}

/** Divides the lines of a shape like its mesh. Returns `false` if the warp does not draw lines. */
function divideStrokes(renderer: Renderer, shape: DrawnShape, divided: Divided): boolean {
  if (!isStrokeShader(stateOf(renderer).userStrokeShader)) return false
  if (!('lines' in divided)) divided.lines = linesOf(renderer, shape)
  const { lines, mesh, standIn, buffers } = divided
  if (!lines) return false
  if (divided.version === mesh.version) return true
  divided.version = mesh.version
  const arrays = divideLines(lines, mesh.lines(lines.ends), mesh.values(-1))
  lines.columns.forEach(({ buffer: { src } }, i) => {
    standIn.dirtyFlags[src] = false
    Object.defineProperty(standIn, src, {
      value: { length: arrays[i]!.length },
      configurable: true,
    })
  })
  uploadLines(
    renderer,
    lines.columns.map(({ buffer: { dst } }, i) => [dst, arrays[i]!] as const),
    buffers,
  )
  return true
}
