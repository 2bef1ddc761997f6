// The value of a uniform as numbers: a number, a list, a vector or a colour of p5; or as an image.
import { WarpError, describe } from '../../errors/errors.js'
import { isList } from '../../options/options.js'
import { type Shape, typeOf } from '../expression/shapes.js'
import type { ImageLike } from '../types/types.js'

/** Maps the count of a value's numbers to its shape. */
const shapes: Record<number, Shape> = {
  1: [1, 1],
  2: [1, 2],
  3: [1, 3],
  4: [1, 4],
  9: [3, 3],
  16: [4, 4],
}

/** Makes the shape of a uniform; `undefined` if none has that count of numbers. `readAsWhole` marks one uniform by it, so no two share it. */
export function shapeFor(numbers: readonly number[] | undefined): Shape | undefined {
  const shape = numbers && shapes[numbers.length]
  return shape && [...shape]
}

/**
 * The numbers of a value for a uniform that is there already. `place` opens the message; `isOwn` says that the uniform's
 * own function gave the value.
 */
export function numbersFor(place: string, shape: Shape, value: unknown, isOwn = false): number[] {
  const count = shape[0] * shape[1]
  const numbers = numbersOf(value, count)
  if (numbers?.length !== count) {
    const came = numbers && shapes[numbers.length]
    const is = came ? `a ${typeOf(came)}` : describe(value)
    throw new WarpError(
      isOwn
        ? `${place} was a ${typeOf(shape)} when the warp was made, but its function now gives ${is}; it must stay what it was.`
        : `${place} is a ${typeOf(shape)} and takes ${count === 1 ? 'a number' : `an array of ${count} numbers${shape[0] > 1 ? ', column by column' : ''}`}, but ${is} came.`,
    )
  }
  checkFinite(place, numbers)
  if (wholes.has(shape)) checkWhole(place, numbers)
  return numbers
}

/** The shapes, each of one uniform, of those that shader text reads as whole numbers. */
const wholes = new WeakSet<Shape>()

export const isWhole = ({ shape }: { shape: Shape }) => wholes.has(shape)

export const readAsWhole = (shape: Shape) => void wholes.add(shape)

/** They reach it as floats, which tell no larger ones apart. */
export function checkWhole(place: string, numbers: readonly number[]) {
  const large = numbers.find((number) => Math.abs(number) > 2 ** 24)
  if (large)
    throw new WarpError(`${place} is read as a whole number, at most 16777216, but is ${large}.`)
}

/** Tests for a width and a height, as p5's images, graphics, framebuffers and videos have, and elements of the page. */
export const isImage = (value: unknown): value is ImageLike =>
  typeof value === 'object' && value !== null && 'width' in value && 'height' in value

/** A value for an image that is there already. */
export function imageFor(place: string, value: unknown): ImageLike {
  if (isImage(value)) return value
  throw new WarpError(
    `${place} must be an image, such as one of loadImage or createGraphics, but is ${describe(value)}.`,
  )
}

/**
 * `undefined` if it is no value of a uniform. A p5.Vector has three numbers and a p5.Color four, of which the first are taken
 * where a shorter vector is wanted.
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

/** The numbers of a p5.Vector or p5.Color; of anything else itself. */
export function componentsOf(value: object): unknown {
  if ('x' in value && 'y' in value && 'z' in value) return [value.x, value.y, value.z]
  return '_array' in value ? value._array : value
}

export function checkFinite(place: string, numbers: readonly unknown[]) {
  const wrong = numbers.find((number) => !Number.isFinite(number))
  if (wrong === undefined && !numbers.includes(undefined)) return
  const came = typeof wrong === 'number' ? wrong : describe(wrong)
  throw new WarpError(
    numbers.length === 1
      ? `${place} must be a finite number, but is ${came}.`
      : `${place} must have finite numbers, but has ${came} among them.`,
  )
}

/** A list of one number becomes the number. */
export const scalarOrArray = (numbers: number[]) => (numbers.length === 1 ? numbers[0]! : numbers)
