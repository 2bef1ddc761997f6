/**
 * The p5 addon: `p5.registerAddon(warpjet)` on 2.x, `warpjet(p5)` on 2.x and 1.11 alike. p5 is not imported here: it
 * cannot load without a browser, and beside a script tag it would be a second copy of p5.
 */
import { WarpError, describe } from '../errors/errors.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type Distort, createWarp as create, putOnAgain } from './create-warp.js'
import { type Canvas, rendererOf, sketchRemoved } from './host.js'
import { dropStrokes, hasStrokes, strokeWasCalled } from './strokes.js'
import {
  type LoadModelOptions,
  type ModelOf,
  type Preloading,
  awaitable,
  emptyModel,
  fillModel,
} from './geometry/load-model.js'
import type { CreateWarpOptions } from './settings.js'
import { giveArrays } from './variation/variation-buffers.js'
import { drawBox } from './geometry/dense-shapes.js'
import { type SubdivideOptions, subdivideShape } from './geometry/subdivide.js'
import type { Makers, WarpModel } from './geometry/model.js'
import { addSurfaceVariation } from './variation/add-surface-variation.js'
import { watchShaderCalls } from './page/shader-calls.js'

/**
 * What the addon adds to a sketch and to a p5.Graphics. TypeScript lets nobody add to the default export that p5's own
 * types are: write `p as p5 & Warping`, or use the function `createWarp` below.
 */
export interface Warping {
  createWarp<const Uniforms extends UniformValues = {}>(
    offset: OffsetFunction<NoInfer<Uniforms>>,
    options?: CreateWarpOptions<Uniforms>,
  ): Distort<Uniforms>
  /**
   * Draws p5's `box(width, height, depth)` with `detail` squares along each edge, 20 unless given, so that a warp can bend it.
   * Throws a `WarpError`.
   */
  warpBox(width?: number, height?: number, depth?: number, detail?: number): this
}

/** `sketch.createWarp(offset, options)` without registering anything; `canvas` is a sketch or a p5.Graphics. */
export const createWarp = <const Uniforms extends UniformValues = {}>(
  canvas: object,
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options?: CreateWarpOptions<Uniforms>,
): Distort<Uniforms> => create(canvas as Canvas, offset as OffsetFunction, options)

/** What it adds to a sketch alone. */
export interface Loading {
  /**
   * A .glb, .gltf, .obj or .stl file as a p5.Geometry for `model()`. On p5 2.x it is awaited; on 1.x it may be called in
   * `preload()` as `loadModel` is, or awaited.
   */
  loadWarpModel<Sketch>(
    this: Sketch,
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<ModelOf<Sketch>>
  /**
   * Finds out how normals and uvs vary over a p5.Geometry, for warps that depend on them, and keeps it with the geometry,
   * which comes back: `bumpy = await addSurfaceVariation(buildGeometry(() => sphere(100)))`. To be called again after its
   * vertices have changed. Needs p5 2. Throws a `WarpError`.
   */
  addSurfaceVariation<Geometry extends object>(geometry: Geometry): Promise<Geometry>
  /**
   * A p5.Geometry with more vertices, for a warp to bend: with a number, each triangle becomes four so many times; or where the
   * warp needs them, `await subdivide(shape, { warp: wave, tolerance: 0.5 })`, in units of the shape, where `wave` is what createWarp or
   * compileWarp returned. Its uniforms are what they are at this moment, unless the option "uniforms" says otherwise. The shape that
   * comes in stays as it is. Throws a `WarpError`.
   */
  subdivide<Geometry extends object>(
    geometry: Geometry,
    options: number | SubdivideOptions,
  ): Promise<Geometry & { warnings: string[] }>
}

interface P5 extends Makers {
  prototype: SketchMethods
  Shader?: { prototype: object }
  Graphics: { prototype: Methods }
  registerAddon?(addon: unknown): void
}

type Method = (...args: unknown[]) => unknown

interface Methods
  extends
    Partial<Warping>,
    Partial<Record<'normalMaterial' | 'stroke' | 'shader' | 'resetShader', Method>> {
  registerMethod?(event: 'remove', listener: (this: Canvas) => void): void
}

interface SketchMethods extends Methods, Partial<Pick<Loading, 'addSurfaceVariation'>> {
  subdivide?(this: Canvas, shape: unknown, options: unknown): Promise<WarpModel>
  loadWarpModel?(
    this: Canvas & Preloading,
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<WarpModel>
  registerPreloadMethod?(name: string, methods: object): void
}

const registered = Symbol.for('warpjet')

/**
 * Adds `createWarp` and `warpBox` to p5 and p5.Graphics, and `loadWarpModel`, `addSurfaceVariation` and `subdivide` to p5. Doing it again changes nothing. Throws a `WarpError`
 * if what came is not p5.
 */
export function warpjet(p5: object, _fn?: object, lifecycles?: { remove?: unknown }): void {
  const host = p5 as P5
  if (typeof p5 !== 'function' || !host.Graphics)
    throw new WarpError(
      `warpjet: p5 itself was expected, as in: import p5 from 'p5', then warpjet(p5); but ${describe(p5)} came.`,
    )
  if (!lifecycles && host.registerAddon) return host.registerAddon(warpjet)
  if (registered in p5) return
  Object.defineProperty(p5, registered, { value: true })

  for (const methods of [host.prototype, host.Graphics.prototype]) addMethods(host, methods)
  addLoading(host, !lifecycles)
  giveArrays(host.Geometry as never)
  if (lifecycles) lifecycles.remove = sketchRemoved
  else host.prototype.registerMethod?.('remove', sketchRemoved)
}

function addMethods(p5: P5, methods: Methods) {
  methods.warpBox = function (this: object, ...sizes) {
    drawBox(p5, this, ...sizes)
    return this as never
  }
  methods.createWarp = function (offset, options) {
    return createWarp(this, offset, options)
  }
  // On 1.11 a p5.Graphics takes these methods from p5 itself.
  after(methods, 'normalMaterial', putOnAgain)
  after(methods, 'stroke', (canvas) => {
    strokeWasCalled(canvas)
    if (rendererOf(canvas) && !hasStrokes(canvas)) putOnAgain(canvas)
  })
  after(methods, 'shader', dropStrokes)
  after(methods, 'resetShader', dropStrokes)
  watchShaderCalls(p5, methods)
}

/** Lets `work` follow each call of one of p5's methods. */
function after(methods: Methods, name: keyof Methods, work: (canvas: Canvas) => void) {
  const method = methods[name] as ((...args: unknown[]) => unknown) | undefined
  if (!method) return
  methods[name] = function (this: Canvas, ...args: unknown[]) {
    const result = method.apply(this, args)
    work(this)
    return result
  } as never
}

function addLoading(p5: P5, preloads: boolean) {
  p5.prototype.loadWarpModel = function (this: Canvas & Preloading, url, options) {
    const model = emptyModel(p5, this._renderer)
    const filling = fillModel(model, p5, url, options)
    return preloads ? awaitable(model, filling, this) : filling.then(() => model)
  }
  p5.prototype.addSurfaceVariation = addSurfaceVariation
  p5.prototype.subdivide = function (shape, options) {
    return subdivideShape(p5, this._renderer, shape, options as number)
  }
  p5.prototype.registerPreloadMethod?.('loadWarpModel', p5.prototype)
}
