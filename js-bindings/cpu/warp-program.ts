// What a warp that runs on the CPU keeps of its session, for other modules of ours too: they need nothing that runs it.
import type { Program } from '../core/module/kept-module.js'
import type { DeclaredUniforms } from '../core/inputs/declared-uniforms.js'
import type { Uniforms } from '../core/inputs/vertices.js'

/** What is kept of a session. There is no program if the warp calls a `glsl.fn` or `glsl.texture`. */
export interface WarpProgram {
  /** The option `uniforms`. */
  declared: DeclaredUniforms
  /** The uniforms that the program reads in place of others, from the values of these. */
  valuesOfFrame?:
    | ((method: string, given: Readonly<Record<string, unknown>>) => Record<string, number[]>)
    | undefined
  program: () => Program | undefined
  /** Its results are the position and what the tangent's direction becomes. */
  directionProgram: () => Program | undefined
  /** Its result is -1 if the warp mirrors all of space, otherwise 1. It reads no vertex. */
  orientationProgram: () => Program
  hasNormals: boolean
  /** Whether the turn depends on how normal and uv vary over the surface. */
  varies: boolean
  /** Whether they may count as constant nevertheless. */
  isAccepted: boolean
  /** By input of the warp, the number of the program's. */
  inputs: Record<string, number>
}

/** A `WarpProgram` that is running. */
export interface RunningProgram extends WarpProgram {
  /** Returns whether the warp mirrors all of space, so that the back of each triangle is the outer side. */
  isMirrored: (method: string, uniforms: Uniforms | undefined) => boolean
  /** Like `isMirrored`, but without uniforms: `undefined` if it depends on them. */
  mirrors: () => boolean | undefined
}

/** Where a warp keeps it, for other modules of ours. */
export const warpProgram = Symbol.for('warpjet.program')
