// The numbers of a program's input, of what the host has there.
import { finiteFloat, readNumbers } from '../../options/numbers.js'
import { Place } from '../../options/place.js'
import { type ReadAsFloats, type Variable, asFloat } from '../expression/shapes.js'

/** Throws for what does not fit. */
export function inputNumbers(
  place: Place | string,
  { shape: [columns, rows], read }: Variable,
  value: unknown,
  test = finiteFloat,
  layout = '',
): number[] {
  const given = read?.type === 'bool' && typeof value === 'boolean' ? Number(value) : value
  const numbers = readNumbers(place, given, columns * rows, test, layout)
  return read ? numbers.map((number) => asFloat(read, whole(place, read, number))) : numbers
}

/** Conditions are 1 and 0. */
function whole(place: Place | string, { type }: ReadAsFloats, number: number): number {
  const [min, max] = type.startsWith('b')
    ? [0, 1]
    : type.startsWith('u')
      ? [0, 2 ** 32 - 1]
      : [-(2 ** 31), 2 ** 31 - 1]
  if (Number.isInteger(number) && number >= min! && number <= max!) return number
  throw Place.of(place).expected(
    `a whole number from ${min} to ${max}, as ${/^i/.test(type) ? 'an' : 'a'} ${type} of the shader is,`,
    `${number}`,
  )
}
