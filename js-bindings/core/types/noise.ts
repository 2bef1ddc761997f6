// The types of the noise functions. src/noise implements them and names its sources.
//
// Coordinates count cells, with about one bump per cell: `position.mult(0.01).noise()` has one every 100 pixels. Noise repeats after
// 4,091 cells along each axis (simplex: of its skewed grid). In a shader, values within 1,000 cells of the origin are exact to
// 1e-4. The same point and seed give the same number in every language and on the CPU. A fragment shader needs
// `precision highp float`. All noises can be differentiated three times. All throw a `WarpError` for unknown or wrong options.
import type { Operand, Scalar, Vec2, Vec3, Vec4 } from './types.js'

export interface NoiseOptions {
  /** Selects another field of the same kind: a whole number from -8,388,608 to 8,388,608. Each is the same field shifted along the
   * first axis, to one of 4,091 places in random order, mostly hundreds of cells apart.
   * @default 0 */
  seed?: number
}

/** A noise from which others are composed. */
export type BaseNoise = 'noise' | 'simplex' | 'valueNoise'

export interface CurlOptions extends NoiseOptions {
  /** The noise whose curl is the field.
   * @default 'noise' */
  noise?: BaseNoise
}

export interface FractalOptions extends NoiseOptions {
  /** The number of noises that are added, from 1 to 16.
   * @default 5 */
  octaves?: number
  /** The ratio of an octave's frequency to that of the octave before, above 0. It may be an expression, such as a uniform, which
   * must stay above 0 for the range of the noise to hold.
   * @default 2 */
  lacunarity?: Operand
  /** The ratio of an octave's amplitude to that of the octave before, above 0. It may be an expression.
   * @default 0.5 */
  gain?: Operand
  /** The noise of an octave.
   * @default 'noise' */
  noise?: BaseNoise
}

/** A point in one to four dimensions. The fourth may be time, for a field that moves. */
type Point = Operand | Vec2 | Vec3 | Vec4

export interface NoiseFunctions {
  /** Gradient noise from -1 to 1, mostly from -0.5 to 0.5: smooth bumps, 0 at whole coordinates. Its first and second
   * derivatives are continuous. */
  noise(point: Point, options?: NoiseOptions): Scalar
  /** Simplex noise from -1 to 1: bumps without a preferred direction. Its first three derivatives are continuous. */
  simplex(point: Point, options?: NoiseOptions): Scalar
  /** Value noise from -1 to 1: random numbers at whole coordinates, interpolated. Its first and second derivatives are
   * continuous. */
  valueNoise(point: Point, options?: NoiseOptions): Scalar
  /** The distances to the nearest and to the second nearest of random points, of which each cell has one: from 0 to about 1 and
   * 1.5, in cells. They are continuous; their slopes jump where another point becomes the nearest. */
  worley(point: Operand | Vec2 | Vec3, options?: NoiseOptions): Vec2
  /** A vector field without sources or sinks, like the flow of a fluid: the curl of three noises. Vectors have lengths of about 1 to
   * 2. The fourth component of a vec4 is time. */
  curl(point: Vec3 | Vec4, options?: CurlOptions): Vec3
  /** Octaves of noise, each finer and weaker than the one before, from -1 to 1, mostly within a third of that. */
  fbm(point: Point, options?: FractalOptions): Scalar
  /** Octaves of sharp ridges, from 0 to 1. Its slope jumps on them. */
  ridged(point: Point, options?: FractalOptions): Scalar
  /** Octaves of the absolute value of noise, from 0 to 1: billows. Its slope jumps where the noise is 0. */
  turbulence(point: Point, options?: FractalOptions): Scalar
}

/** The noises as methods: `point.noise(options)` is `glsl.noise(point, options)`. */
export interface FieldMethods {
  /** Gradient noise at this point, from -1 to 1: smooth bumps, 0 at whole coordinates. */
  noise(options?: NoiseOptions): Scalar
  /** Simplex noise at this point, from -1 to 1: bumps without a preferred direction. */
  simplex(options?: NoiseOptions): Scalar
  /** Value noise at this point, from -1 to 1: random numbers at whole coordinates, interpolated. */
  valueNoise(options?: NoiseOptions): Scalar
  /** Octaves of noise at this point, each finer and weaker than the one before, from -1 to 1. */
  fbm(options?: FractalOptions): Scalar
  /** Octaves of sharp ridges at this point, from 0 to 1. */
  ridged(options?: FractalOptions): Scalar
  /** Octaves of billows at this point, from 0 to 1. */
  turbulence(options?: FractalOptions): Scalar
}

export interface NoiseMethods extends FieldMethods {
  /** The distances from this point to the nearest and to the second nearest of random points, of which each cell has one. */
  worley(options?: NoiseOptions): Vec2
}

export interface CurlMethod {
  /** A vector field without sources or sinks at this point, like the flow of a fluid. */
  curl(options?: CurlOptions): Vec3
}
