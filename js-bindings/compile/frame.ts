/**
 * What a text reads that is the same for a whole frame, computed once a frame on the CPU: in double, so that a sketch may run for a
 * week, and less by whole periods where it is added inside of something periodic.
 */
import { runInDouble } from '../cpu/double.js'
import { type KeptModule, type Known, makeFrame } from '../core/module/kept-module.js'
import type { Variable } from '../core/expression/shapes.js'

/** By name, vec4s for uniforms of the shader. */
export type FrameConstants = Readonly<Record<string, readonly number[]>>

export const isFrameConstant = ({ name }: { name: string }) => /^warpjetFrame\d+$/.test(name)

const nothing: FrameConstants = {}

/**
 * `read` gives the numbers of a known input. It is called only for inputs that the frame constants depend on. While these stay
 * the same, so does the object.
 */
export function frameOf(module: KeptModule, isKnown: Known) {
  const frame = makeFrame(module, isKnown)
  if (!frame) return () => nothing
  const { program, count, isRead } = frame
  const needed = program.inputs.filter((_, i) => isRead[i])
  let last: { numbers: (readonly number[])[]; constants: FrameConstants } | undefined
  return (read: (variable: Variable) => readonly number[]): FrameConstants => {
    const numbers = needed.map(read)
    if (last && areSame(numbers, last.numbers)) return last.constants
    const given = numbers.values()
    const inputs = program.inputs.flatMap((variable, i) =>
      isRead[i] ? [...given.next().value!] : Array<number>(sizeOf(variable)).fill(0),
    )
    const values = runInDouble(program, inputs, 4 * count)
    const constants = Object.fromEntries(
      Array.from({ length: count }, (_, i) => [`warpjetFrame${i}`, values.slice(4 * i, 4 * i + 4)]),
    )
    last = { numbers, constants }
    return constants
  }
}

/** For numbers of the same inputs. */
const areSame = (a: readonly (readonly number[])[], b: readonly (readonly number[])[]) =>
  a.every((list, i) => list.every((number, k) => Object.is(number, b[i]![k])))

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows
