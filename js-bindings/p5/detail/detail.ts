/**
 * The option `detail` of `createWarp`: while a warp's shader is in use, p5 draws shapes with as many triangles as their warped surface
 * needs on the screen. p5 draws a stand-in for the shape, whose buffers are written here; its shaders stay as they are.
 */
import type { HostWarp } from '../../compile/hosts.js'
import { DetailedMesh } from '../../detail/detailed-mesh.js'
import { sketchOf, stateOf, type Canvas, type Renderer, type Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { upload, type ShapeBuffers } from './buffers.js'
import { baseOf, type DrawnShape, type ShapeBase } from './shape.js'
import { viewOf } from './views.js'

/** The warp of a shader, for drawing it with detail. */
export interface DetailOfWarp {
  readonly canvas: Canvas
  readonly warp: HostWarp
  readonly space: WarpSpace
  /** In pixels. */
  readonly tolerance: number
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
  if (drawing._drawFills) hookDrawFills(renderer, drawing as never)
  else hookDrawBuffers(renderer, drawing as never)
}

const hooked = new WeakSet<Renderer>()

type DrawFills = (shape: DrawnShape, options?: { mode?: unknown; count?: number }) => void
type DrawBuffers = (name: string) => unknown

interface Drawing {
  /** 2.x only. */
  _drawFills?: DrawFills
  readonly geometryBufferCache?: { readonly cache: Record<string, ShapeBuffers> }
  /** 1.11 only. */
  drawBuffers?: DrawBuffers
}

/** p5's name of the shape between beginShape() and endShape(), which is a different one each time. */
const immediate = '__IMMEDIATE_MODE_GEOMETRY__'

function hookDrawFills(renderer: Renderer, drawing: Required<Drawing>) {
  const draw = drawing._drawFills
  drawing._drawFills = function (shape, options) {
    const division =
      shape.gid === immediate || (options?.count ?? 1) > 1 ? undefined : divide(renderer, shape)
    if (!division) return draw.call(this, shape, options)
    const { cache } = drawing.geometryBufferCache
    const { standIn, buffers } = division
    cache[standIn.gid!] = buffers
    try {
      draw.call(this, standIn, options)
    } finally {
      delete cache[standIn.gid!]
    }
  }
}

/** On 1.11, renderers map a shape's name to its buffers, of which one is called `model` and is the shape. */
function hookDrawBuffers(renderer: Renderer, drawing: Required<Drawing>) {
  const draw = drawing.drawBuffers
  const shapes = renderer.retainedMode!.geometry as Record<string, ShapeBuffers>
  drawing.drawBuffers = function (name) {
    const before = shapes[name]!
    const divided = before && divide(renderer, before.model as DrawnShape)
    if (!divided || renderer.geometryBuilder) return draw.call(this, name)
    const { standIn, buffers } = divided
    const vertexCount = 3 * standIn.faces.length
    shapes[name] = Object.assign(Object.create(before), buffers, { model: standIn, vertexCount })
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
  const draws = drawsFor(renderer, shader, shape, sketchOf(canvas).frameCount ?? 0)
  if (draws.count > maxDrawsPerFrame || !hasInputs(warp, draws.base)) return undefined
  const division = (draws.divided[draws.count - 1] ??= makeDivided(warp, shape, draws.base))
  const { views, toSpace, place } = viewOf(canvas, renderer, space)
  if (division.mesh.update(values, views, tolerance, toSpace, place))
    refresh(renderer, shape, draws.base, division)
  return division
}

function drawsFor(renderer: Renderer, shader: Shader, shape: DrawnShape, frame: number): Draws {
  let byShader = drawsOf.get(shape)
  if (!byShader) drawsOf.set(shape, (byShader = new WeakMap<Shader, Draws>()))
  let draws = byShader.get(shader)
  // p5 sets a flag to `false` when it has read the array; a sketch sets it to `true` when it has changed the array.
  const isChanged = Object.values(shape.dirtyFlags).includes(true)
  if (!draws || isChanged || draws.vertices !== shape.vertices.length) {
    for (const { mesh } of draws?.divided ?? []) mesh.dispose()
    // Compiles the shader, which knows its attributes then.
    ;(shader as { init?: () => void }).init?.()
    const base = baseOf(renderer, shader, shape)
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
  return { mesh: new DetailedMesh(warp, base), standIn, buffers: { geometry: standIn } }
}

/** Uploads a divided mesh, and gives its stand-in the lengths of its arrays. p5 reads no more of them, as they are not dirty. */
function refresh(renderer: Renderer, shape: DrawnShape, base: ShapeBase, divided: Divided) {
  const { mesh, standIn, buffers } = divided
  upload(renderer, base, mesh, buffers)
  const vertices = mesh.values(-1).length / 3
  const own = {
    dirtyFlags: { vertices: false } as DrawnShape['dirtyFlags'],
    vertices: { length: vertices },
    faces: { length: mesh.indices().length / 3 },
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

/** p5 2.x marks colors that it has filled in itself. */
const isDefault = (array: unknown) =>
  (array as { isDefault?: boolean } | undefined)?.isDefault ? { isDefault: true } : {}
