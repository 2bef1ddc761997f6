// Converts a value of the host to the numbers of a program's input.
import { readNumbers, type NumberTest } from '../../options/numbers.js'
import type { Place } from '../../options/place.js'
import { asFloat, type ReadAsFloats, type Variable } from '../expression/shapes.js'

/** Reads a value as numbers. Conditions are 1 and 0. */
export function inputNumbers(
  place: Place,
  { shape: [columns, rows], read }: Variable,
  value: unknown,
  test?: NumberTest,
): number[] {
  const numeric = read?.type === 'bool' && typeof value === 'boolean' ? Number(value) : value
  const layout = columns > 1 ? ', column by column,' : ''
  const numbers = readNumbers(place, numeric, columns * rows, { test, layout })
  return read ? numbers.map((number) => asFloat(read, checkWhole(place, read, number))) : numbers
}

/** Returns the number; throws unless it is a whole number that the type can represent. */
function checkWhole(place: Place, { type }: ReadAsFloats, number: number): number {
  const [min, max] = type.startsWith('b')
    ? [0, 1]
    : type.startsWith('u')
      ? [0, 2 ** 32 - 1]
      : [-(2 ** 31), 2 ** 31 - 1]
  if (Number.isInteger(number) && number >= min! && number <= max!) return number
  throw place.expected(
    `a whole number from ${min} to ${max}, as ${/^i/.test(type) ? 'an' : 'a'} ${type} of the shader is,`,
    `${number}`,
  )
}
