// Checks numbers that users pass, alone or in arrays.
import { describe } from '../errors/errors.js'
import { isFiniteFloat, isList } from './guards.js'
import type { Place } from './place.js'

export interface NumberTest {
  /** The adjective for accepted numbers in messages, followed by a space; empty for none. */
  adjective: string
  accepts: (value: unknown) => boolean
}

/** Accepts numbers that are finite as a float32. */
export const finiteFloat: NumberTest = { adjective: 'finite ', accepts: isFiniteFloat }

/** Accepts numbers that are finite as a double. */
export const finiteDouble: NumberTest = { adjective: 'finite ', accepts: Number.isFinite }

/** Accepts every number, also NaN and Infinity, but no string, null, boolean or BigInt, which typed arrays would convert. */
export const anyNumber: NumberTest = {
  adjective: '',
  accepts: (value) => typeof value === 'number',
}

/** Returns the index of the first value that the test rejects, or -1. */
export function firstWrong(numbers: ArrayLike<unknown>, test: NumberTest) {
  if (numbers instanceof Float32Array) {
    if (test === anyNumber) return -1
    // x * 0 is 0 for a finite x and NaN otherwise, so that one sum tests many numbers: several times as fast as testing each number.
    // The processor computes four independent sums in parallel.
    const { length } = numbers
    let [a, b, c, d] = [0, 0, 0, 0]
    let i = 0
    for (; i + 3 < length; i += 4) {
      a += numbers[i]! * 0
      b += numbers[i + 1]! * 0
      c += numbers[i + 2]! * 0
      d += numbers[i + 3]! * 0
    }
    for (; i < length; i++) a += numbers[i]! * 0
    if (a + b + c + d === 0) return -1
  }
  for (let i = 0; i < numbers.length; i++) if (!test.accepts(numbers[i])) return i
  return -1
}

/** Describes a value that was passed instead of a valid number. */
export const describeNumber = (value: unknown) =>
  typeof value === 'number' ? `${value}` : describe(value)

/** Copies a finite number, or an array of finite numbers as long as `numbers`, into `numbers`. Returns `false` for other values. */
export function copyNumbers(numbers: number[], value: unknown): boolean {
  if (typeof value === 'number') {
    numbers[0] = value
    return numbers.length === 1 && isFiniteFloat(value)
  }
  if (!isList(value) || value.length !== numbers.length) return false
  for (let i = 0; i < numbers.length; i++) {
    const number = value[i]!
    if (!isFiniteFloat(number)) return false
    numbers[i] = number
  }
  return true
}

interface NumbersOptions {
  test?: NumberTest
  /** The order of the numbers in messages, such as `, column by column,`. */
  layout?: string | undefined
  /** The value that the user passed, if `value` was extracted from it. */
  given?: unknown
  advice?: string | undefined
}

/** Reads a single number or an array of `count` numbers, and returns an array. */
export function readNumbers(
  place: Place,
  value: unknown,
  count: number,
  { test = finiteFloat, layout = '', given = value, advice }: NumbersOptions = {},
): number[] {
  const list = count === 1 && typeof value === 'number' ? [value] : value
  const hasRightLength = isList(list) && list.length === count
  const wrongIndex = hasRightLength ? firstWrong(list, test) : -1
  if (hasRightLength && wrongIndex < 0) return Array.from(list)
  const wrongNumber = hasRightLength && describeNumber(list[wrongIndex])
  throw place.expected(
    count === 1
      ? `a ${test.adjective}number`
      : `an array of ${count} ${test.adjective}numbers${layout}`,
    !wrongNumber ? describe(given) : count === 1 ? wrongNumber : `one with ${wrongNumber}`,
    advice,
  )
}
