// The noise functions as a sketch sees them. They are in src/noise, where their sources are named.
//
// A coordinate counts cells: noise has one bump a cell or so, hence `position.mult(0.01).noise()` one
// every 100 pixels. It repeats after 4,091 cells along each axis (simplex: of its pressed grid). In a
// shader, within a thousand cells of the origin, values are right to 1e-4. The same point and seed give the
// same number in every language and on the CPU. In a fragment shader it needs `precision highp float`.
// Derivatives of any kind can be taken three times. All throw a `WarpError` for unknown or wrong options.
import type { Operand, Scalar, Vec2, Vec3, Vec4 } from './types.js'

export interface NoiseOptions {
  /** Another field of the same kind: a whole number from -8,388,608 to 8,388,608; 0 unless given. Each is the same field
   * moved along the first axis, to one of 4,091 places in no order, hundreds of cells apart as a rule. */
  seed?: number
}

/** A noise that others are made of. */
export type BaseNoise = 'noise' | 'simplex' | 'valueNoise'

export interface CurlOptions extends NoiseOptions {
  /** What the field is the curl of; `'noise'` unless given. */
  noise?: BaseNoise
}

export interface FractalOptions extends NoiseOptions {
  /** How many noises are added, from 1 to 16; 5 unless given. */
  octaves?: number
  /** How many times as fine as the one before an octave is, above 0; 2 unless given. An expression will do, such as a
   * uniform; it has to stay above 0 for the range to hold. */
  lacunarity?: Operand
  /** How many times as strong as the one before an octave is, above 0; 0.5 unless given. An expression will do. */
  gain?: Operand
  /** What an octave is; `'noise'` unless given. */
  noise?: BaseNoise
}

/** A point of one to four dimensions. Three and one more for time make a field that moves. */
type Point = Operand | Vec2 | Vec3 | Vec4

export interface NoiseFunctions {
  /** Gradient noise from -1 to 1, most of it within half of that: smooth bumps, 0 at whole coordinates. Its first and second
   * derivatives have no jumps. */
  noise(point: Point, options?: NoiseOptions): Scalar
  /** Simplex noise from -1 to 1: bumps that favour no axis. Its first three derivatives have no jumps. */
  simplex(point: Point, options?: NoiseOptions): Scalar
  /** Value noise from -1 to 1: random numbers at whole coordinates, blended. Its first and second derivatives have no
   * jumps. */
  valueNoise(point: Point, options?: NoiseOptions): Scalar
  /** The distances to the nearest and to the second nearest of random points, one a cell: from 0 to about 1 and 1.5, in
   * cells. They have no jumps; their slopes do where another point becomes the nearest. */
  worley(point: Operand | Vec2 | Vec3, options?: NoiseOptions): Vec2
  /** A field of vectors without sources or sinks, as a fluid flows: the curl of three noises, about 1 to 2 long. Of a vec4, the
   * last number is time. */
  curl(point: Vec3 | Vec4, options?: CurlOptions): Vec3
  /** Octaves of noise, each finer and weaker than the one before, from -1 to 1; most of it within a third of that. */
  fbm(point: Point, options?: FractalOptions): Scalar
  /** The same of sharp ridges, from 0 to 1. Its slope jumps on them. */
  ridged(point: Point, options?: FractalOptions): Scalar
  /** The same of noise without its sign, from 0 to 1: billows. Its slope jumps where the noise is 0. */
  turbulence(point: Point, options?: FractalOptions): Scalar
}

/** `point.noise(options)` for `glsl.noise(point, options)`, and so with all others, which say more. */
export interface FieldMethods {
  /** Gradient noise at this point, from -1 to 1: smooth bumps, 0 at whole coordinates. */
  noise(options?: NoiseOptions): Scalar
  /** Simplex noise at this point, from -1 to 1: bumps that favour no axis. */
  simplex(options?: NoiseOptions): Scalar
  /** Value noise at this point, from -1 to 1: random numbers at whole coordinates, blended. */
  valueNoise(options?: NoiseOptions): Scalar
  /** Octaves of noise at this point, each finer and weaker than the one before, from -1 to 1. */
  fbm(options?: FractalOptions): Scalar
  /** Octaves of sharp ridges at this point, from 0 to 1. */
  ridged(options?: FractalOptions): Scalar
  /** Octaves of billows at this point, from 0 to 1. */
  turbulence(options?: FractalOptions): Scalar
}

export interface NoiseMethods extends FieldMethods {
  /** From this point, the distances to the nearest and to the second nearest of random points, one a cell. */
  worley(options?: NoiseOptions): Vec2
}

export interface CurlMethod {
  /** At this point, a field of vectors that flows as a fluid does, without sources or sinks. */
  curl(options?: CurlOptions): Vec3
}
