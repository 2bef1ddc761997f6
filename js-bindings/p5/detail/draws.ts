/** Divides shapes: separately for each draw of a shape with a shader in a frame, since each draw has its own view. */
import type { HostWarp } from '../../compile/hosts.js'
import { DetailedMesh } from '../../detail/detailed-mesh.js'
import type { GpuBuffer } from '../../detail/gpu/webgpu.js'
import type { DetailSettings } from '../../detail/option.js'
import { warnOfDetail } from '../../detail/warnings.js'
import { sketchOf, type Canvas, type Renderer, type Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import {
  destroyOnGpu,
  submitDraws,
  submitEarlierFrames,
  upload,
  type ShapeBuffers,
} from './buffers.js'
import { ShapePasses, type ComputedDraw } from './computed-draw.js'
import type { LineBase } from './lines.js'
import { baseOf, drawnIndices, type DrawnShape, type ShapeBase } from './shape.js'
import { viewOf } from './views.js'

/** The warp of a shader that draws shapes with detail. */
export interface DetailOfWarp extends DetailSettings {
  readonly canvas: Canvas
  readonly warp: HostWarp
  readonly space: WarpSpace
  /** The values of the draw call. */
  values: Readonly<Record<string, unknown>>
}

/** A shape that is divided for one of its draws in a frame. */
export interface Divided {
  readonly mesh: DetailedMesh
  readonly standIn: DrawnShape
  /** The buffers that the CPU fills. */
  readonly buffers: ShapeBuffers
  readonly computed: ComputedDraw | undefined
  /** Absent before strokes are drawn; `undefined` if they are not divided. */
  lines?: LineBase | undefined
  /** The version of the mesh for which the lines are divided. */
  version: number
}

/** A division as p5 draws it in place of a shape. */
export interface Division {
  readonly divided: Divided
  readonly buffers: ShapeBuffers
  /** The arguments of an indirect call; present if compute passes have divided the shape. */
  readonly drawn?: GpuBuffer
}

/** The draws of a shape with a shader. */
interface Draws {
  readonly base: ShapeBase
  readonly vertices: number
  /** See `changesOf`. */
  readonly changes: number
  readonly passes: ShapePasses | undefined
  /** The frame of the last draw, and the number of draws in that frame. */
  frame: number
  count: number
  /** `true` if the shape was drawn in an earlier frame, and has not changed since. */
  isUnchanged: boolean
  readonly divided: Divided[]
}

/** The max number of draws of a shape in a frame that are divided, since each has its own buffers. */
const maxDrawsPerFrame = 100

const drawsOf = new WeakMap<DrawnShape, WeakMap<Shader, Draws>>()

/** Divides a shape for a draw with its shader. Returns `undefined` if the shape is not divided. */
export function divide(
  renderer: Renderer,
  shader: Shader,
  shape: DrawnShape,
  detail: DetailOfWarp,
): Division | undefined {
  const { canvas, warp, space, tolerance, values: given } = detail
  const draws = drawsFor(renderer, shader, shape, detail)
  const { base, passes, isUnchanged } = draws
  const obstacle = obstacleOf(warp, draws)
  if (obstacle) warnOfDetail(warp, 'createWarp', 'a shape', obstacle)
  if (obstacle || !base.positions.length) return undefined
  draws.divided[draws.count - 1] ??= makeDivided(warp, shape, draws)
  const divided = draws.divided[draws.count - 1]!
  const { mesh, buffers, computed } = divided
  const { views, toSpace, place } = viewOf(canvas, renderer, space)
  if (passes) passes.place = place
  const indirect = computed?.divide({ given, views, tolerance, toSpace, place })
  if (indirect) {
    destroyOnGpu(buffers)
    return { divided, ...indirect }
  }
  if (mesh.update(given, views, tolerance, toSpace, place) || !buffers.indexBuffer)
    refresh(renderer, shape, base, divided)
  // For a shape that changes in each frame, compute passes would start anew in each frame.
  if (isUnchanged) computed?.takeOver()
  return { divided, buffers }
}

function drawsFor(
  renderer: Renderer,
  shader: Shader,
  shape: DrawnShape,
  { canvas, warp, isCurved }: DetailOfWarp,
): Draws {
  const frame = sketchOf(canvas).frameCount ?? 0
  submitEarlierFrames(renderer, frame)
  let byShader = drawsOf.get(shape)
  if (!byShader) drawsOf.set(shape, (byShader = new WeakMap<Shader, Draws>()))
  let draws = byShader.get(shader)
  const changes = changesOf(shape)
  if (draws?.changes !== changes || draws.vertices !== shape.vertices.length) {
    freeDraws(renderer, shader, shape)
    // Compiles the shader, so that its attributes are known.
    ;(shader as { init?: () => void }).init?.()
    const base = baseOf(renderer, shader, shape, isCurved)
    const passes = ShapePasses.of(renderer, warp, base)
    const vertices = shape.vertices.length
    draws = { base, vertices, changes, passes, frame, count: 0, isUnchanged: false, divided: [] }
    byShader.set(shader, draws)
  }
  if (draws.frame !== frame) Object.assign(draws, { frame, count: 0, isUnchanged: true })
  draws.count++
  return draws
}

const changeCounts = new WeakMap<DrawnShape, number>()

/**
 * Counts how often the sketch has changed an array of the shape: then the flag of the array is `true`. p5 sets the flag to `false` when it
 * reads the array, which it does not do while it draws a stand-in. So we set it to `undefined`: changed, but not read by p5.
 */
function changesOf(shape: DrawnShape): number {
  const changed = Object.keys(shape.dirtyFlags).filter((name) => shape.dirtyFlags[name] === true)
  for (const name of changed) shape.dirtyFlags[name] = undefined
  const count = (changeCounts.get(shape) ?? 0) + Number(changed.length > 0)
  if (changed.length) changeCounts.set(shape, count)
  return count
}

/** Frees the memory of the divisions of a shape. */
export function freeDraws(renderer: Renderer, shader: Shader, shape: DrawnShape) {
  const all = drawsOf.get(shape)?.get(shader)?.divided.splice(0) ?? []
  if (all.length) submitDraws(renderer)
  for (const { mesh, buffers, computed } of all) {
    mesh.dispose()
    computed?.release()
    destroyOnGpu(buffers)
  }
}

/** Describes why the present draw of a shape is not divided; `undefined` if it is. */
function obstacleOf(warp: HostWarp, { base, count }: Draws): string | undefined {
  if (count > maxDrawsPerFrame)
    return `only the first ${maxDrawsPerFrame} draws of a shape in a frame are divided`
  for (const name of ['normal', 'uv', 'color'] as const)
    if (warp.reads(name) && !base.attributes.some(({ input }) => input === `${name}s`))
      return `it has no ${name}s, which the offset reads`
  return undefined
}

let count = 0

function makeDivided(warp: HostWarp, shape: DrawnShape, { base, passes }: Draws): Divided {
  const standIn = Object.create(shape) as DrawnShape
  standIn.gid = `warpjet detail ${count++}`
  const mesh = new DetailedMesh(warp, base)
  const computed = passes?.draw(mesh)
  return { mesh, standIn, buffers: { geometry: standIn }, computed, version: 0 }
}

/** Uploads a divided mesh, and sets the lengths of the arrays of its stand-in. p5 reads nothing else of these arrays, since they are not dirty. */
function refresh(renderer: Renderer, shape: DrawnShape, base: ShapeBase, divided: Divided) {
  const { mesh, standIn, buffers } = divided
  upload(renderer, base, mesh, buffers)
  divided.version = 0
  const vertices = mesh.values(-1).length / 3
  const own = {
    dirtyFlags: { vertices: false } as DrawnShape['dirtyFlags'],
    vertices: { length: vertices },
    faces: { length: drawnIndices(base, mesh).length / 3 },
  }
  base.buffers.forEach(({ src, size }) => {
    own.dirtyFlags[src] = false
    Object.defineProperty(standIn, src, {
      value: Object.assign({ length: size * vertices }, copyIsDefault(shape[src])),
      configurable: true,
    })
  })
  Object.assign(standIn, own)
}

/** Copies the mark by which p5 2.x recognizes colors that it has filled in itself. */
const copyIsDefault = (array: unknown) =>
  (array as { isDefault?: boolean } | undefined)?.isDefault ? { isDefault: true } : {}
