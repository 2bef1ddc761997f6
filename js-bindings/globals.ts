/**
 * 'warpjet/globals': what the two scripts add to a page, for sketches in global mode, in types alone: `"types":
 * ["warpjet/globals"]` in tsconfig.json or jsconfig.json, or `/// <reference types="warpjet/globals" />` in the sketch.
 */
import type * as deformers from './deformers.js'
import type { CreateWarpOptions, Distort, LoadModelOptions, ModelOf } from './p5.js'
import type * as compiler from './index.js'
import type { operators } from './operators.js'

type Compiler = Pick<typeof compiler, 'WarpError' | 'compile' | 'compileWarp' | 'gen' | 'version'>

declare global {
  /** What p5.warpjet.min.js has beside p5's functions, and after warpjet.deformers.min.js the deformers, after warpjet.operators.min.js
   * `operators`. */
  const warpjet: Compiler & typeof deformers & { operators: typeof operators }

  /** glsl-autodiff's global. */
  const AutoDiff: Pick<Compiler, 'gen'>

  /**
   * Compiles an offset function into p5's shaders. What it returns puts the warp on what is drawn next. Throws a
   * `WarpError`.
   */
  function createWarp<const Uniforms extends compiler.UniformValues = {}>(
    offset: compiler.OffsetFunction<NoInfer<Uniforms>>,
    options?: CreateWarpOptions<Uniforms>,
  ): Distort<Uniforms>

  /** A .glb, .gltf or .obj file as a p5.Geometry for `model()`: awaited on p5 2, on 1.11 called in `preload()`. */
  function loadWarpModel(
    url: string | URL,
    options?: LoadModelOptions,
  ): Promise<ModelOf<typeof globalThis>>

  /**
   * Finds out how normals and uvs vary over a p5.Geometry, for warps that depend on them, and keeps it with the geometry,
   * which comes back. Needs p5 2. Throws a `WarpError`.
   */
  function addSurfaceVariation<Geometry extends object>(geometry: Geometry): Promise<Geometry>
}
