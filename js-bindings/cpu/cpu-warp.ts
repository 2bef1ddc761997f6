// The methods of a warp on the CPU, which run the graph of its shader source on the vertices of a mesh.
import type { VertexInput } from '../core/inputs/inputs.js'
import type { Box, Uniforms, Vertices } from '../core/inputs/vertices.js'
import type { WarpedVertices } from './results.js'
import type { RunningProgram, warpProgram } from './warp-program.js'

export interface EvaluationOptions {
  /** Those left out have the values of `compileWarp`'s option `uniforms`; a function there is called each time. */
  uniforms?: Uniforms | undefined
}

export interface EvaluateOptions extends EvaluationOptions {
  /**
   * Arrays of yours that receive the results. Each must be at least as long as its result; missing ones are created. The same
   * arrays are returned, in this object if it holds no others. They may be inputs or share memory with inputs, but two results
   * that share memory throw a `WarpError`. Calls that reuse the arrays create no garbage, unless a uniform's function does, or a
   * result would overwrite an input that has yet to be read, which is copied first.
   */
  out?: Partial<WarpedVertices> | undefined
}

/** What the warp is to know of one vertex; the numbers of each as in `Vertices`. */
export interface PointInputs
  extends Partial<Record<Exclude<VertexInput, 'position'>, ArrayLike<number>>>, EvaluationOptions {}

export interface WarpedPoint {
  position: number[]
  /** If a normal came. */
  normal?: number[]
  /** If a normal and a tangent came. */
  tangent?: number[]
}

export interface InverseOptions
  extends Partial<Record<'normal' | 'uv' | 'color', ArrayLike<number>>>, EvaluationOptions {
  /** Where the search starts; the point itself unless given. Give where the point came from a moment ago. */
  near?: ArrayLike<number> | undefined
}

export interface WarpInverse {
  /** The place that the warp brings the point from: if there are several, the one that the way from `near` leads to. */
  position: number[]
  /** Whether space is inside out there, det(I + J) not above 0. Then other places come to the point too, which are found from
   * another `near`, unless the warp mirrors all of space or the point lies just on a crease. Where it is false others may
   * come there as well: of three layers of a fold only the one in the middle is inside out. */
  isFolded: boolean
}

/** Bounds of x, y and z, without NaN. `min` is above `max` for a coordinate that is NaN everywhere. */
export interface Bounds {
  min: number[]
  max: number[]
}

export interface Foldover {
  /** 1 for each vertex where det(I + J) is not above 0, so that space is inside out there, or no number; 0 elsewhere. If
   * the offset depends on normal or uv, space is the thin layer around the surface where these stay the same along each
   * normal: its two sides have changed places there. */
  mask: Uint8Array
  /** How many those are. */
  count: number
}

/**
 * All throw a `WarpError` for arrays that do not fit, numbers that are not finite, a uniform or an attribute that the warp
 * reads and does not get, a uniform that it does not know, and a warp that calls a `glsl.fn` or `glsl.texture`, which only the GPU can run.
 * They compute in float32, as the GPU does, and change nothing that comes in. Where the offset function has no finite
 * value, such as the logarithm of a negative number, neither have the results.
 */
export interface CpuWarp {
  /**
   * Moves vertices, any number, even none: it needs the results' memory, unless `out` has it, and a few megabytes. Numbers of
   * a Float32Array are checked when it comes for the first time; what is written into it later is the caller's care.
   */
  evaluate(mesh: Vertices, options?: EvaluateOptions): WarpedVertices
  /** Moves one vertex. */
  evaluateAt(position: ArrayLike<number>, inputs?: PointInputs): WarpedPoint
  /**
   * A box around all that the warp makes of `box`: never too small for what `evaluate` gives, and seldom much larger than
   * that. A GPU whose sine is less exact, as WebGPU allows to 2^-11, may go beyond by that part of a wave's height. It takes
   * from a tenth of a millisecond to some tens, for warps that are hard to bound. Where the offset depends on them, normals count as any numbers from -1 to 1, colors from 0 to 1, and texture coordinates from 0 to 1
   * unless `box.uvs` says otherwise. A side is infinite if the offset may be.
   *
   * The bounds of each coordinate contain all of its values except NaN: for sqrt(x) with x from -1 to 1, which is NaN on one
   * half, they are 0 and 1. So finite bounds do not guarantee that each vertex has a finite position. If a coordinate is NaN
   * everywhere, its `min` is Infinity and its `max` is -Infinity, as for an empty box.
   */
  bounds(box: Box, options?: EvaluationOptions): Bounds
  /**
   * Where the warp brings a point from, such as what of a calm sea is under a boat: evaluateAt of `position` is the point, up
   * to float32. In double, the warp moves `position` to within 1e-9 of the point's distance from the origin, plus at most 1e-10
   * for rounding. It is one place, and says whether that is in a fold; `undefined` if the search meets none, which proves
   * nothing of places that it does not come near. In double, by Newton's method with the exact Jacobian, each
   * step halved until it leads closer, and the way to the point taken in pieces where that fails. Normals and the like
   * count as constant. A warp compiled with `normals: false` has no Jacobian, and throws.
   */
  inverseAt(point: ArrayLike<number>, options?: InverseOptions): WarpInverse | undefined
  /** Where the warp turns the surface inside out. */
  foldover(mesh: Vertices, options?: EvaluationOptions): Foldover
  /** @internal */
  readonly [warpProgram]: RunningProgram
}
