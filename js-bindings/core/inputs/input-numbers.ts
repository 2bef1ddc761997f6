// The numbers of a program's input, of what the host has there.
import { WarpError } from '../../errors/errors.js'
import { finiteFloat, readNumbers } from '../../options/numbers.js'
import { type ReadAsFloats, type Variable, asFloat } from '../expression/shapes.js'

/** Throws for what does not fit; `place` names it. */
export function inputNumbers(
  place: string,
  { shape: [columns, rows], read }: Variable,
  value: unknown,
  kind = finiteFloat,
  layout = '',
): number[] {
  const given = read?.type === 'bool' && typeof value === 'boolean' ? Number(value) : value
  const numbers = readNumbers(place, given, columns * rows, kind, layout)
  return read ? numbers.map((number) => asFloat(read, whole(place, read, number))) : numbers
}

/** Conditions are 1 and 0. */
function whole(place: string, { type }: ReadAsFloats, number: number): number {
  const [least, most] = type.startsWith('b')
    ? [0, 1]
    : type.startsWith('u')
      ? [0, 2 ** 32 - 1]
      : [-(2 ** 31), 2 ** 31 - 1]
  if (Number.isInteger(number) && number >= least! && number <= most!) return number
  throw new WarpError(
    `${place} is ${/^i/.test(type) ? 'an' : 'a'} ${type} of the shader, a whole number from ${least} to ${most}, but is ${number}.`,
  )
}
