/**
 * 'warpjet/globals': what the scripts add to a page, for sketches in global mode, in types alone: `"types":
 * ["warpjet/globals"]` in tsconfig.json or jsconfig.json, or `/// <reference types="warpjet/globals" />` in the sketch.
 */
import type * as deformers from './deformers.js'
import type * as glsl from './glsl.js'
import type * as operators from './operators.js'
import type { CreateWarpOptions, Distort, LoadModelOptions, ModelOf } from './p5.js'
import type { AdaptiveOptions, LevelsOptions } from './mesh.js'
import type * as compiler from './warpjet.js'

type Compiler = Pick<typeof compiler, 'WarpError' | 'compile' | 'compileWarp' | 'gen' | 'version'>

declare global {
  /** What p5.warpjet.min.js has beside p5's functions, and after warpjet.deformers.min.js, warpjet.glsl.min.js and
   * warpjet.operators.min.js what those add. */
  const warpjet: Compiler & typeof deformers & typeof glsl & typeof operators

  /** glsl-autodiff's global. */
  const AutoDiff: Pick<Compiler, 'gen'>

  /**
   * Compiles an offset function, which says how far each vertex moves, into p5's shaders. What it returns puts the warp on what
   * is drawn next. Throws a `WarpError`.
   */
  function createWarp<const Uniforms extends compiler.UniformValues = {}>(
    offset: compiler.OffsetFunction<NoInfer<Uniforms>>,
    options?: CreateWarpOptions<Uniforms>,
  ): Distort<Uniforms>

  /** A .glb, .gltf, .obj or .stl file as a p5.Geometry for `model()`: awaited on p5 2, on 1.11 called in `preload()`. */
  function loadWarpModel(
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<ModelOf<typeof globalThis>>

  /**
   * Finds out how normals and uvs vary over a p5.Geometry, for warps that depend on them, and keeps it with the geometry,
   * which comes back. Needs p5 2. Throws a `WarpError`.
   */
  function addSurfaceVariation<Geometry extends object>(geometry: Geometry): Promise<Geometry>

  /** Draws p5's `box(width, height, depth)` with `detail` squares along each edge, 20 unless given, so that a warp can bend it. */
  function warpBox(width?: number, height?: number, depth?: number, detail?: number): void

  /**
   * A p5.Geometry with more vertices: with a number, each triangle becomes four so many times; or where the warp needs them,
   * `await subdivide(shape, { warp: warpjet.compileWarp(offset), tolerance: 0.5 })`, in units of the shape. Throws a `WarpError`.
   */
  function subdivide<Geometry extends object>(
    geometry: Geometry,
    options: number | AdaptiveOptions | LevelsOptions,
  ): Promise<Geometry & { warnings: string[] }>

  /**
   * A shader of `modify()` or `buildMaterialShader()` with normals that are turned as its hooks move positions. Needs
   * warpjet.glsl.min.js. Where that cannot be done, the console says why, and the shader comes back as it was.
   */
  function exactNormals<Shader extends object>(shader: Shader): Shader
}
