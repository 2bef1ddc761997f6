/**
 * What a text reads that is the same for a whole frame, computed once a frame on the CPU: in double, so that a sketch may run for a
 * week, and less by whole periods where it is added inside of something periodic.
 */
import { runInDouble } from '../cpu/double.js'
import { type Known, makeFrame } from '../core/module/kept-module.js'
import type { Variable } from '../core/expression/shapes.js'
import type { KeptWarp } from './warp-text.js'

/** By name, vec4s for uniforms of the shader. */
export type FrameUniforms = Record<string, number[]>

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows

/** `read` gives the numbers of a known input. It is called only for inputs that the frame constants depend on. */
export function frameOf({ module }: KeptWarp, isKnown: Known) {
  const frame = makeFrame(module, isKnown)
  if (!frame) return undefined
  const { program, count, isRead } = frame
  return (read: (variable: Variable) => readonly number[]): FrameUniforms => {
    const inputs = program.inputs.flatMap((variable, i) =>
      isRead[i] ? [...read(variable)] : Array<number>(sizeOf(variable)).fill(0),
    )
    const values = runInDouble(program, inputs, 4 * count)
    return Object.fromEntries(
      Array.from({ length: count }, (_, i) => [`warpjetFrame${i}`, values.slice(4 * i, 4 * i + 4)]),
    )
  }
}
