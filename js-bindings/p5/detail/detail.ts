/**
 * The option `detail` of `createWarp`: while a warp's shader is in use, p5 draws shapes with as many triangles as their warped surface
 * needs on the screen. p5 draws a stand-in for the shape, whose buffers are written here; its shaders stay as they are.
 */
import type { HostWarp } from '../../compile/hosts.js'
import { DetailedMesh } from '../../detail/detailed-mesh.js'
import type { DetailSettings } from '../../detail/option.js'
import {
  immediateShape,
  sketchOf,
  stateOf,
  type Canvas,
  type Renderer,
  type Shader,
} from '../host.js'
import type { WarpSpace } from '../settings.js'
import { isStrokeShader } from '../strokes.js'
import { upload, uploadLines, type ShapeBuffers } from './buffers.js'
import { divideLines, linesOf, type LineBase } from './lines.js'
import { baseOf, drawnIndices, type DrawnShape, type ShapeBase } from './shape.js'
import { viewOf } from './views.js'

/** The warp of a shader, for drawing it with detail. */
export interface DetailOfWarp extends DetailSettings {
  readonly canvas: Canvas
  readonly warp: HostWarp
  readonly space: WarpSpace
  /** The values of the draw call. */
  values: Readonly<Record<string, unknown>>
}

/** More draws of one shape in one frame keep the vertices that the shape has, as each has its own buffers. */
const maxDrawsPerFrame = 100

const details = new WeakMap<Shader, DetailOfWarp>()

/** Draws shapes with detail while this shader is in use. */
export function useDetail(renderer: Renderer, shader: Shader, detail: DetailOfWarp) {
  details.set(shader, detail)
  if (hooked.has(renderer)) return
  hooked.add(renderer)
  const drawing = renderer as unknown as Drawing
  if (drawing._drawGeometry) hookDrawGeometry(renderer, drawing as never)
  else hookDrawBuffers(renderer, drawing as never)
}

const hooked = new WeakSet<Renderer>()

type Draw = (shape: DrawnShape, options?: { mode?: unknown; count?: number }) => void
type DrawBuffers = (name: string) => unknown

interface Drawing {
  /** 2.x only: it calls the two others. */
  _drawGeometry?: Draw
  _drawFills?: Draw
  _drawStrokes?: Draw
  readonly geometryBufferCache?: { readonly cache: Record<string, ShapeBuffers> }
  /** 1.11 only. */
  drawBuffers?: DrawBuffers
}

function hookDrawGeometry(renderer: Renderer, drawing: Required<Drawing>) {
  const { _drawGeometry, _drawFills, _drawStrokes } = drawing
  /** The division of the shape that is drawn now, which its fill and its strokes share; `undefined` before both. */
  let current: { readonly division: Divided | undefined } | undefined
  const drawDivided = (draw: Draw, own: DrawnShape, options: Parameters<Draw>[1]) => {
    const isUndivided = own.gid === immediateShape || (options?.count ?? 1) > 1
    current ??= { division: isUndivided ? undefined : divide(renderer, own) }
    const { division } = current
    if (!division || (draw === _drawStrokes && !divideStrokes(renderer, own, division)))
      return draw.call(renderer, own, options)
    const { cache } = drawing.geometryBufferCache
    const { standIn, buffers } = division
    cache[standIn.gid!] = buffers
    try {
      draw.call(renderer, standIn, options)
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
}

/** On 1.11, renderers map a shape's name to its buffers, of which one is called `model` and is the shape. */
function hookDrawBuffers(renderer: Renderer, drawing: Required<Drawing>) {
  const draw = drawing.drawBuffers
  const shapes = renderer.retainedMode!.geometry as Record<string, ShapeBuffers>
  drawing.drawBuffers = function (name) {
    const before = shapes[name]!
    // A GeometryBuilder collects shapes, and draws none.
    const isDrawn = before && !renderer.geometryBuilder
    const division = isDrawn ? divide(renderer, before.model as DrawnShape) : undefined
    if (!division) return draw.call(this, name)
    const { standIn, buffers } = division
    const shape = before.model as DrawnShape
    shapes[name] = Object.assign(Object.create(before), buffers, {
      model: standIn,
      vertexCount: 3 * standIn.faces.length,
      ...(divideStrokes(renderer, shape, division) && {
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

/** A shape as it is divided for one of its draws in a frame. */
interface Divided {
  readonly mesh: DetailedMesh
  readonly standIn: DrawnShape
  readonly buffers: ShapeBuffers
  /** Missing before strokes are drawn, `undefined` if they are not divided. */
  lines?: LineBase | undefined
  /** The version of the mesh that the lines are of. */
  version: number
}

/** The draws of a shape with a shader. */
interface Draws {
  readonly base: ShapeBase
  readonly vertices: number
  /** The last frame, and the number of draws in it. */
  frame: number
  count: number
  readonly divided: Divided[]
}

const drawsOf = new WeakMap<DrawnShape, WeakMap<Shader, Draws>>()

/** Returns `undefined` if the shape is to be drawn as it is. */
function divide(renderer: Renderer, shape: DrawnShape): Divided | undefined {
  const shader = stateOf(renderer).userFillShader
  const detail = shader && details.get(shader)
  if (!detail || !shape.faces?.length) return undefined
  const { canvas, warp, space, tolerance, values } = detail
  const draws = drawsFor(renderer, shader, shape, detail)
  if (draws.count > maxDrawsPerFrame || !hasInputs(warp, draws.base)) return undefined
  const division = (draws.divided[draws.count - 1] ??= makeDivided(warp, shape, draws.base))
  const { views, toSpace, place } = viewOf(canvas, renderer, space)
  if (division.mesh.update(values, views, tolerance, toSpace, place))
    refresh(renderer, shape, draws.base, division)
  return division
}

function drawsFor(
  renderer: Renderer,
  shader: Shader,
  shape: DrawnShape,
  { canvas, isCurved }: DetailOfWarp,
): Draws {
  const frame = sketchOf(canvas).frameCount ?? 0
  let byShader = drawsOf.get(shape)
  if (!byShader) drawsOf.set(shape, (byShader = new WeakMap<Shader, Draws>()))
  let draws = byShader.get(shader)
  // p5 sets a flag to `false` when it has read the array; a sketch sets it to `true` when it has changed the array.
  const isChanged = Object.values(shape.dirtyFlags).includes(true)
  if (!draws || isChanged || draws.vertices !== shape.vertices.length) {
    for (const { mesh } of draws?.divided ?? []) mesh.dispose()
    // Compiles the shader, which knows its attributes then.
    ;(shader as { init?: () => void }).init?.()
    const base = baseOf(renderer, shader, shape, isCurved)
    draws = { base, vertices: shape.vertices.length, frame, count: 0, divided: [] }
    byShader.set(shader, draws)
  }
  if (draws.frame !== frame) Object.assign(draws, { frame, count: 0 })
  draws.count++
  return draws
}

/** Tests whether the shape has all that the warp reads. */
function hasInputs(warp: HostWarp, { positions, attributes }: ShapeBase): boolean {
  const has = (input: string) => attributes.some((each) => each.input === input)
  return (
    positions.length > 0 &&
    (has('normals') || !warp.reads('normal')) &&
    (has('uvs') || !warp.reads('uv')) &&
    (has('colors') || !warp.reads('color'))
  )
}

let count = 0

function makeDivided(warp: HostWarp, shape: DrawnShape, base: ShapeBase): Divided {
  const standIn = Object.create(shape) as DrawnShape
  standIn.gid = `warpjet detail ${count++}`
  return { mesh: new DetailedMesh(warp, base), standIn, buffers: { geometry: standIn }, version: 0 }
}

/** Uploads a divided mesh, and gives its stand-in the lengths of its arrays. p5 reads no more of them, as they are not dirty. */
function refresh(renderer: Renderer, shape: DrawnShape, base: ShapeBase, divided: Divided) {
  const { mesh, standIn, buffers } = divided
  upload(renderer, base, mesh, buffers)
  const vertices = mesh.values(-1).length / 3
  const own = {
    dirtyFlags: { vertices: false } as DrawnShape['dirtyFlags'],
    vertices: { length: vertices },
    faces: { length: drawnIndices(base, mesh).length / 3 },
  }
  base.buffers.forEach(({ src, size }) => {
    own.dirtyFlags[src] = false
    Object.defineProperty(standIn, src, {
      value: Object.assign({ length: size * vertices }, isDefault(shape[src])),
      configurable: true,
    })
  })
  Object.assign(standIn, own)
}

/** Divides the lines of a shape as its mesh is, and returns `true`; `false` if lines are not drawn by the warp. */
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

/** p5 2.x marks colors that it has filled in itself. */
const isDefault = (array: unknown) =>
  (array as { isDefault?: boolean } | undefined)?.isDefault ? { isDefault: true } : {}
