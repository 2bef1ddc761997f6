/**
 * The p5 addon: `p5.registerAddon(warpjet)` on 2.x, `warpjet(p5)` on 2.x and 1.11 alike. p5 is not imported here: it
 * cannot load without a browser, and beside a script tag it would be a second copy of p5.
 */
import type { OffsetFunction, UniformValues } from '../compile/hosts.js'
import { WarpError, describe } from '../errors/errors.js'
import { createWarp as create, reapplyWarp, type Distort } from './create-warp.js'
import { drawBox } from './geometry/dense-shapes.js'
import {
  emptyModel,
  fillModel,
  makeAwaitable,
  type LoadModelOptions,
  type ModelOf,
  type Preloading,
} from './geometry/load-model.js'
import type { P5Constructors, WarpModel } from './geometry/model.js'
import { subdivideShape, type SubdivideOptions } from './geometry/subdivide.js'
import { markSketchRemoved, rendererOf, type Canvas } from './host.js'
import { watchShaderCalls } from './page/shader-calls.js'
import type { CreateWarpOptions } from './settings.js'
import { dropStrokes, hasStrokes, recordStrokeCall } from './strokes.js'
import { addSurfaceVariation } from './variation/add-surface-variation.js'
import { defineVariationArrays } from './variation/variation-buffers.js'

/**
 * Methods that the addon adds to sketches and to p5.Graphics. TypeScript cannot extend the default export of p5's own types, so
 * write `p as p5 & Warping`, or use the function `createWarp` below.
 */
export interface Warping {
  createWarp<const Uniforms extends UniformValues = {}>(
    offset: OffsetFunction<NoInfer<Uniforms>>,
    options?: CreateWarpOptions<Uniforms>,
  ): Distort<Uniforms>
  /**
   * Draws p5's `box(width, height, depth)` with `detail` squares along each edge (default: 20), so that a warp can bend it.
   * Throws a `WarpError` for a wrong argument or a canvas that is not 3D.
   */
  warpBox(width?: number, height?: number, depth?: number, detail?: number): this
}

/** Does the same as `sketch.createWarp(offset, options)`, but needs no registered addon; `canvas` is a sketch or a p5.Graphics. */
export const createWarp = <const Uniforms extends UniformValues = {}>(
  canvas: object,
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options?: CreateWarpOptions<Uniforms>,
): Distort<Uniforms> => create(canvas as Canvas, offset as OffsetFunction, options)

/** Methods that the addon adds to sketches only. */
export interface Loading {
  /**
   * Loads a .glb, .gltf, .obj or .stl file as a p5.Geometry for `model()`. On p5 2.x, await it; on 1.x, call it in `preload()`
   * like `loadModel`, or await it.
   */
  loadWarpModel<Sketch>(
    this: Sketch,
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<ModelOf<Sketch>>
  /**
   * Computes how normals and uvs vary over a p5.Geometry, for warps that depend on them, stores the result in the geometry and
   * returns the geometry: `bumpy = await addSurfaceVariation(buildGeometry(() => sphere(100)))`. Call it again after the
   * vertices have changed. Needs p5 2. Throws a `WarpError` for anything but a geometry of p5 2.
   */
  addSurfaceVariation<Geometry extends object>(geometry: Geometry): Promise<Geometry>
  /**
   * Returns a copy of a p5.Geometry with more vertices, for a warp to bend. A number n splits each triangle into four, n times;
   * `await subdivide(shape, { warp: wave, tolerance: 0.5 })` adds vertices only where the warp needs them. The tolerance is in units of
   * the shape, and `wave` is the result of createWarp or compileWarp. The warp's uniforms have their current values, unless the option
   * "uniforms" overrides them. The original shape is not changed. Throws a `WarpError` for a shape without triangles, and for wrong
   * options.
   */
  subdivide<Geometry extends object>(
    geometry: Geometry,
    options: number | SubdivideOptions,
  ): Promise<Geometry & { warnings: string[] }>
}

interface P5 extends P5Constructors {
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
 * Adds `createWarp` and `warpBox` to p5 and p5.Graphics, and `loadWarpModel`, `addSurfaceVariation` and `subdivide` to p5. A second
 * call has no effect. Throws a `WarpError` if the argument is not p5.
 */
export function warpjet(p5: object, _fn?: object, lifecycles?: { remove?: unknown }): void {
  const host = p5 as P5
  if (typeof p5 !== 'function' || !host.Graphics)
    throw new WarpError(
      `warpjet: expected p5 itself, as in: import p5 from 'p5', then warpjet(p5); got ${describe(p5)}.`,
    )
  if (!lifecycles && host.registerAddon) return host.registerAddon(warpjet)
  if (registered in p5) return
  Object.defineProperty(p5, registered, { value: true })

  for (const methods of [host.prototype, host.Graphics.prototype]) addMethods(host, methods)
  addLoading(host, !lifecycles)
  defineVariationArrays(host.Geometry as never)
  if (lifecycles) lifecycles.remove = markSketchRemoved
  else host.prototype.registerMethod?.('remove', markSketchRemoved)
}

function addMethods(p5: P5, methods: Methods) {
  methods.warpBox = function (this: object, ...sizes) {
    drawBox(p5, this, ...sizes)
    return this as never
  }
  methods.createWarp = function (offset, options) {
    return createWarp(this, offset, options)
  }
  // On 1.11 a p5.Graphics inherits these methods from p5 itself.
  runAfter(methods, 'normalMaterial', reapplyWarp)
  runAfter(methods, 'stroke', (canvas) => {
    recordStrokeCall(canvas)
    if (rendererOf(canvas) && !hasStrokes(canvas)) reapplyWarp(canvas)
  })
  runAfter(methods, 'shader', dropStrokes)
  runAfter(methods, 'resetShader', dropStrokes)
  watchShaderCalls(p5, methods)
}

/** Wraps one of p5's methods, so that `work` runs after each call. */
function runAfter(methods: Methods, name: keyof Methods, work: (canvas: Canvas) => void) {
  const method = methods[name] as ((...args: unknown[]) => unknown) | undefined
  if (!method) return
  methods[name] = function (this: Canvas, ...args: unknown[]) {
    const result = method.apply(this, args)
    work(this)
    return result
  } as never
}

function addLoading(p5: P5, hasPreload: boolean) {
  p5.prototype.loadWarpModel = function (this: Canvas & Preloading, url, options) {
    const model = emptyModel(p5, this._renderer)
    const filling = fillModel(model, p5, url, options)
    return hasPreload ? makeAwaitable(model, filling, this) : filling.then(() => model)
  }
  p5.prototype.addSurfaceVariation = addSurfaceVariation
  p5.prototype.subdivide = function (shape, options) {
    return subdivideShape(p5, this._renderer, shape, options as number)
  }
  p5.prototype.registerPreloadMethod?.('loadWarpModel', p5.prototype)
}
