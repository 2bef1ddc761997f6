/**
 * 'warpjet/globals': the types of the globals that this library's scripts add to a page, for sketches in global mode. Use
 * `"types": ["warpjet/globals"]` in tsconfig.json or jsconfig.json, or `/// <reference types="warpjet/globals" />` in the sketch.
 */
import type * as deformers from './deformers.js'
import type * as glsl from './glsl.js'
import type { AdaptiveOptions, LevelsOptions } from './mesh.js'
import type * as operators from './operators.js'
import type { CreateWarpOptions, Distort, LoadModelOptions, ModelOf } from './p5.js'
import type * as compiler from './warpjet.js'

type Compiler = Pick<typeof compiler, 'WarpError' | 'compile' | 'compileWarp' | 'gen' | 'version'>

declare global {
  /** The functions of p5.warpjet.min.js that are not added to p5, and those that warpjet.deformers.min.js, warpjet.glsl.min.js and
   * warpjet.operators.min.js add. */
  const warpjet: Compiler & typeof deformers & typeof glsl & typeof operators

  /** glsl-autodiff's global. */
  const AutoDiff: Pick<Compiler, 'gen'>

  /**
   * Compiles an offset function, which returns how far each vertex moves, into p5's shaders. Returns a function that applies the
   * warp to the shapes drawn after it. Throws a `WarpError` for an offset function that misuses an operation, and for wrong options.
   */
  function createWarp<const Uniforms extends compiler.UniformValues = {}>(
    offset: compiler.OffsetFunction<NoInfer<Uniforms>>,
    options?: CreateWarpOptions<Uniforms>,
  ): Distort<Uniforms>

  /** Loads a .glb, .gltf, .obj or .stl file as a p5.Geometry for `model()`: with `await` on p5 2, in `preload()` on 1.11. */
  function loadWarpModel(
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<ModelOf<typeof globalThis>>

  /**
   * Computes how normals and uvs vary over a p5.Geometry, for warps that depend on them, stores the result with the geometry, and
   * returns the geometry. Needs p5 2. Throws a `WarpError` for anything but a geometry.
   */
  function addSurfaceVariation<Geometry extends object>(geometry: Geometry): Promise<Geometry>

  /** Draws p5's `box(width, height, depth)` with `detail` squares along each edge, so that a warp can bend it. Default: 20. */
  function warpBox(width?: number, height?: number, depth?: number, detail?: number): void

  /**
   * Makes a p5.Geometry with more vertices. With a number n, each triangle is divided into four n times. With a warp, vertices
   * are added where the warp needs them: `await subdivide(shape, { warp: warpjet.compileWarp(offset), tolerance: 0.5 })`. The tolerance
   * is in units of the shape. Throws a `WarpError` for wrong options.
   */
  function subdivide<Geometry extends object>(
    geometry: Geometry,
    options: number | AdaptiveOptions | LevelsOptions,
  ): Promise<Geometry & { warnings: string[] }>

  /**
   * Makes a shader of `modify()` or `buildMaterialShader()` transform normals to match the positions that its hooks move. Needs
   * warpjet.glsl.min.js. If that is impossible, the console says why, and the shader is returned unchanged.
   *
   * A loop whose end only the shader knows runs until it ends. If it cannot stay a loop in the shader, its normals are those of 256
   * iterations, and a console warning says which loop that is. `options.maxIterations`, from 1 to 4096, limits every such loop and
   * silences the warning.
   */
  function exactNormals<Shader extends object>(
    shader: Shader,
    options?: { maxIterations?: number },
  ): Shader
}
