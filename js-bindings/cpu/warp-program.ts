// The programs of a warp on the CPU. Other modules import this file without the code that evaluates programs.
import type { DeclaredUniforms } from '../core/inputs/declared-uniforms.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import type { Program } from '../core/module/serialized-module.js'
import type { WarpError } from '../errors/errors.js'
import type { Place } from '../options/place.js'

/** The programs of a recorded warp. `program` and `directionProgram` return `undefined` if the warp calls a `glsl.fn` or `glsl.texture`. */
export interface WarpProgram {
  /** The option `uniforms`. */
  declared: DeclaredUniforms
  /** Present if the program reads frame constants: computes them from the values of inputs and uniforms. */
  frameConstants?:
    | ((
        place: Place,
        values: Readonly<Record<string, unknown>>,
      ) => Readonly<Record<string, readonly number[]>>)
    | undefined
  program: () => Program | undefined
  /** Computes the warped position and the warped direction of the tangent. */
  directionProgram: () => Program | undefined
  /** Computes -1 if the warp mirrors all of space, otherwise 1. It reads no vertex. */
  orientationProgram: () => Program
  hasNormals: boolean
  /** True if the warped normal depends on how normal and uv vary over the surface. */
  varies: boolean
  /** True if the user accepts that normal and uv are treated as constant nevertheless. */
  isAccepted: boolean
  /** Maps an input of the warp → its number in the module. */
  inputs: Record<string, number>
}

/** A `WarpProgram` with tests that evaluate it. */
export interface RunningProgram extends WarpProgram {
  /** Tests whether the warp mirrors all of space, so that the back of each triangle is its outer side. */
  isMirrored: (place: Place, uniforms: Uniforms | undefined) => boolean
  /** Returns the result of `isMirrored` if it is the same for all uniforms; `undefined` if it depends on them. */
  mirrors: () => boolean | undefined
}

/** The key of a warp's `RunningProgram`. It is the same in all scripts of a page. */
export const warpProgram = Symbol.for('warpjet.program')

/** Returns a program. Throws a `WarpError` for a warp that only the GPU can evaluate. */
export function programOf(place: Place, warp: WarpProgram, make = warp.program): Program {
  const program = make()
  if (program) return program
  throw place.error(
    'this warp calls a function of glsl.fn or reads an image by glsl.texture, which only the GPU can do.',
  )
}

export function rejectWithoutNormals(place: Place, { hasNormals }: WarpProgram) {
  if (!hasNormals)
    throw place.error(
      'the warp was compiled with "normals: false", which leaves out its derivatives; compile it without.',
    )
}

/** Makes the error for an input that the caller must pass as `name`. */
export const missingInput = (place: Place, input: string, name: string): WarpError =>
  place.error(`the warp reads the ${input} of each vertex; pass "${name}" too.`)
