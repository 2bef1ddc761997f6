// The types of a warp on the CPU, which evaluates the graph of its shader code at the vertices of a mesh.
import type { VertexInput } from '../core/inputs/inputs.js'
import type { Box, Uniforms, Vertices } from '../core/inputs/vertices.js'
import type { WarpedVertices } from './results.js'
import type { RunningProgram, warpProgram } from './warp-program.js'

export interface EvaluationOptions {
  /** Default: the values of `compileWarp`'s option `uniforms`, where a function is called each time. */
  uniforms?: Uniforms | undefined
}

export interface EvaluateOptions extends EvaluationOptions {
  /**
   * Arrays of yours that receive the results. Each must be at least as long as its result; missing ones are created. `evaluate` returns
   * the same arrays, and even this object if it contains exactly these arrays. They may be inputs or share memory with inputs, but two
   * results that share memory throw a `WarpError`. Calls that reuse the arrays create no garbage, unless a uniform's function does, or an
   * input must be copied because a result would overwrite it before it is read.
   */
  out?: Partial<WarpedVertices> | undefined
}

/** The inputs of one vertex, each with as many numbers as in `Vertices`. */
export interface PointInputs
  extends Partial<Record<Exclude<VertexInput, 'position'>, ArrayLike<number>>>, EvaluationOptions {}

export interface WarpedPoint {
  position: number[]
  /** Present if a normal was passed. */
  normal?: number[]
  /** Present if a normal and a tangent were passed. */
  tangent?: number[]
}

export interface InverseOptions
  extends Partial<Record<'normal' | 'uv' | 'color', ArrayLike<number>>>, EvaluationOptions {
  /** The start of the search, ideally the position that was found for the point a moment ago. Default: the point itself. */
  near?: ArrayLike<number> | undefined
}

export interface WarpInverse {
  /** The position that the warp moves to the point: of several, the one that the search from `near` reaches. */
  position: number[]
  /** True if the warp turns space inside out at the position, det(I + J) <= 0. Then the warp also moves other positions to the point, and a
   * search from another `near` can find them. There are two exceptions: the warp mirrors all of space, or the point is exactly on a crease.
   * Other positions may also exist if this is false: of three layers of a fold, only the middle one is inside out. */
  isFolded: boolean
}

/** Bounds of x, y and z, ignoring NaN. `min` exceeds `max` for a coordinate that is NaN everywhere. */
export interface Bounds {
  min: number[]
  max: number[]
}

export interface Foldover {
  /** 1 for each vertex where the warp turns space inside out, det(I + J) <= 0, or where the determinant is NaN; otherwise 0. If the
   * offset depends on normal or uv, space means the thin layer around the surface in which these are constant along each normal:
   * where the mask is 1, the two sides of that layer are swapped. */
  mask: Uint8Array
  /** The number of ones in `mask`. */
  count: number
}

/**
 * All methods throw a `WarpError` for arrays of wrong length, numbers that are not finite, a missing uniform or attribute that the
 * warp reads, an unknown uniform, and a warp that calls a `glsl.fn` or `glsl.texture`, which only the GPU can evaluate. They compute in
 * float32, as the GPU does, and leave their arguments unchanged. Where the offset function has no finite value, such as the
 * logarithm of a negative number, neither have the results.
 */
export interface CpuWarp {
  /**
   * Moves any number of vertices. Needs memory for the results, unless `out` provides it, and a few megabytes. A Float32Array is
   * checked only when it is passed for the first time: numbers that you write into it later must be finite.
   */
  evaluate(mesh: Vertices, options?: EvaluateOptions): WarpedVertices
  /** Moves one vertex. */
  evaluateAt(position: ArrayLike<number>, inputs?: PointInputs): WarpedPoint
  /**
   * Returns a box that contains the warped positions of all points in `box`: never too small for the results of `evaluate`, and
   * seldom much larger. On a GPU with a less exact sine (WebGPU allows an error of 2^-11), a wave may exceed the box by that share of
   * its height. Takes 0.1 ms, up to some 10 ms for warps that are hard to bound. For an offset that depends on normals, colors or texture
   * coordinates, these range from -1 to 1, from 0 to 1, and over `box.uvs`, by default from 0 to 1. A side of the returned box is
   * infinite if the offset may be infinite.
   *
   * The bounds of each coordinate contain all of its values except NaN: for sqrt(x) with x from -1 to 1, which is NaN for
   * negative x, they are 0 and 1. So finite bounds do not guarantee that each vertex has a finite position. If a coordinate is NaN
   * everywhere, its `min` is Infinity and its `max` is -Infinity, as for an empty box.
   */
  bounds(box: Box, options?: EvaluationOptions): Bounds
  /**
   * Finds a position that the warp moves to a point, such as the point of a calm sea that is under a boat: `evaluateAt` of
   * `position` is the point, up to float32. In double precision, the distance is at most 1e-9 of the point's distance from the
   * origin, plus 1e-10 for rounding. Returns one position, and whether it is in a fold; `undefined` if the search finds none, which
   * does not prove that there is none. The search is Newton's method with the exact Jacobian, in double precision, damped by
   * halving each step until it gets closer, and by intermediate goals where that fails. Other inputs, such as the normal, are treated
   * as constant. Throws for a warp compiled with `normals: false`, which has no Jacobian.
   */
  inverseAt(point: ArrayLike<number>, options?: InverseOptions): WarpInverse | undefined
  /** Finds the vertices where the warp turns the surface inside out. */
  foldover(mesh: Vertices, options?: EvaluationOptions): Foldover
  /** @internal */
  readonly [warpProgram]: RunningProgram
}
