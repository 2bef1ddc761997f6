/**
 * Frame constants: values that shader code reads and that are constant during a frame, computed once per frame on the CPU. They are
 * computed in double precision, so that a page may run for a week, and reduced by whole periods where they are added to the
 * argument of a periodic function.
 */
import type { Variable } from '../core/expression/shapes.js'
import {
  makeFrame,
  type IsFrameConstant,
  type SerializedModule,
} from '../core/module/serialized-module.js'
import { runInDouble } from '../cpu/double.js'

/** Maps the name of a uniform of the shader → vec4. */
export type FrameConstants = Readonly<Record<string, readonly number[]>>

/** Tests for a uniform that carries frame constants. */
export const isFrameUniform = ({ name }: { name: string }) => /^warpjetFrame\d+$/.test(name)

const noConstants: FrameConstants = {}

/**
 * Returns a function that computes the constants. That function takes `read`, which returns the numbers of an input, and calls it only
 * for inputs on which the constants depend. While these numbers stay the same, it returns the same object.
 */
export function frameOf(module: SerializedModule, isFrameConstant: IsFrameConstant) {
  const frame = makeFrame(module, isFrameConstant)
  if (!frame) return () => noConstants
  const { program, count, isRead } = frame
  const needed = program.inputs.filter((_, i) => isRead[i])
  let last: { numbers: (readonly number[])[]; constants: FrameConstants } | undefined
  return (read: (variable: Variable) => readonly number[]): FrameConstants => {
    const numbers = needed.map(read)
    if (last && areSame(numbers, last.numbers)) return last.constants
    const remaining = numbers.values()
    const inputs = program.inputs.flatMap((variable, i) =>
      isRead[i] ? [...remaining.next().value!] : Array<number>(sizeOf(variable)).fill(0),
    )
    const values = runInDouble(program, inputs, 4 * count)
    const constants = Object.fromEntries(
      Array.from({ length: count }, (_, i) => [`warpjetFrame${i}`, values.slice(4 * i, 4 * i + 4)]),
    )
    last = { numbers, constants }
    return constants
  }
}

/** Compares two lists of numbers of the same inputs. */
const areSame = (a: readonly (readonly number[])[], b: readonly (readonly number[])[]) =>
  a.every((list, i) => list.every((number, k) => Object.is(number, b[i]![k])))

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows
