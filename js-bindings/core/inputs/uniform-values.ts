// Reads the value of a uniform as numbers (from a number, an array, a vector or colour of p5), or as an image.
import { describe } from '../../errors/errors.js'
import { isList } from '../../options/guards.js'
import { finiteDouble, readNumbers } from '../../options/numbers.js'
import type { Place } from '../../options/place.js'
import type { Shape } from '../expression/shapes.js'
import type { ImageLike } from '../types/types.js'

/** Maps a count of numbers → the shape of a uniform that has them. */
const shapes: Record<number, Shape> = {
  1: [1, 1],
  2: [1, 2],
  3: [1, 3],
  4: [1, 4],
  9: [3, 3],
  16: [4, 4],
}

/**
 * Makes the shape of a uniform; `undefined` if no shape has that count of numbers. Each uniform has its own object, by which
 * `markAsWhole` marks it.
 */
export function shapeFor(numbers: readonly number[] | undefined): Shape | undefined {
  const shape = numbers && shapes[numbers.length]
  return shape && [...shape]
}

/** Reads a new value of a declared uniform. `isReturned` is true if the uniform's function returned the value. */
export function numbersFor(
  place: Place,
  shape: Shape,
  value: unknown,
  isReturned = false,
): number[] {
  const [columns, rows] = shape
  const list = numbersOf(value, columns * rows)
  const numbers = readNumbers(place, list, columns * rows, {
    test: finiteDouble,
    layout: columns > 1 ? ', column by column,' : '',
    given: value,
    advice: isReturned
      ? 'its function must always return a value of the same type as at first'
      : undefined,
  })
  if (wholeShapes.has(shape)) checkWhole(place, numbers)
  return numbers
}

/** The shapes of uniforms that shader source reads as whole numbers. */
const wholeShapes = new WeakSet<Shape>()

export const isWhole = ({ shape }: { shape: Shape }) => wholeShapes.has(shape)

export const markAsWhole = (shape: Shape) => void wholeShapes.add(shape)

/** Rejects numbers beyond 2^24: uniforms are float32, which cannot represent every larger whole number. */
export function checkWhole(place: Place, numbers: readonly number[]) {
  const large = numbers.find((number) => Math.abs(number) > 2 ** 24)
  if (large !== undefined)
    throw place.expected(
      'a number from -16777216 to 16777216',
      `${large}`,
      'the shader reads it as a whole number',
    )
}

/** Tests for an object with width and height, which p5's images, graphics, framebuffers and videos have, and elements of the page. */
export const isImage = (value: unknown): value is ImageLike =>
  typeof value === 'object' && value !== null && 'width' in value && 'height' in value

/** Reads a new value of a uniform that is an image. */
export function imageFor(place: Place, value: unknown): ImageLike {
  if (isImage(value)) return value
  throw place.expected('an image, such as one of loadImage or createGraphics,', describe(value))
}

/**
 * Returns the numbers of a value; `undefined` if it cannot be the value of a uniform. A p5.Vector has 3 numbers and a p5.Color 4; if
 * `count` is smaller, only the first ones are returned.
 */
export function numbersOf(value: unknown, count = Infinity): number[] | undefined {
  if (typeof value === 'number') return [value]
  if (typeof value === 'boolean') return [Number(value)]
  if (isList(value)) return value.length > 1 ? Array.from(value) : undefined
  if (typeof value !== 'object' || value === null) return undefined
  const list = componentsOf(value)
  if (!isList(list)) return undefined
  const numbers = Array.from(list)
  return count > 1 ? numbers.slice(0, count) : numbers
}

/** Returns the numbers of a p5.Vector or p5.Color, and any other value itself. */
export function componentsOf(value: object): unknown {
  if ('x' in value && 'y' in value && 'z' in value) return [value.x, value.y, value.z]
  return '_array' in value ? value._array : value
}

/** Turns an array of one number into the number. */
export const scalarOrArray = (numbers: number[]) => (numbers.length === 1 ? numbers[0]! : numbers)
