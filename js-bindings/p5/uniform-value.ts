// Converts what a sketch passes as the value of a uniform to what p5's `setUniform` accepts, or throws.
import { componentsOf, imageFor } from '../compile/hosts.js'
import { WarpError, describe } from '../errors/errors.js'
import { Place } from '../options/place.js'
import type { Uniform } from './host.js'

export const place = new Place('The function that createWarp returned')

/** Returns an image that p5 can draw. */
export function p5Image(name: string, value: unknown) {
  const image = imageFor(place.uniform(name), value)
  if ('nodeType' in image)
    throw new WarpError(
      `The warp's uniform "${name}": expected an image of p5, got an element of the page.`,
    )
  return image
}

const mat2 = 0x8b5a
const sampler2D = 0x8b5e

/** Maps the WebGL enum of a matrix type to its number of components. */
const matrixSizes: Record<number, number> = { [mat2]: 4, 0x8b5b: 9, 0x8b5c: 16 }

/** Converts the value of a uniform that `defs` declares and that the shader has. */
export function toUniformValue(name: string, value: unknown, uniform: Uniform) {
  const { type, isArray, offset, offsetEnd, packInPlace } = uniform
  /** Number of components (WebGPU only). */
  const items = packInPlace ? 9 : (offsetEnd! - offset!) / 4
  const isList = isArray ?? items > 1
  if (type === mat2 && !isList)
    throw new WarpError(
      `The warp's uniform "${name}" is a mat2, which this p5 cannot set; declare a mat3, or use p5 2.`,
    )
  if (type === sampler2D) return p5Image(name, value)
  const isInvalid =
    value === undefined || value === null || Number.isNaN(value) || typeof value === 'string'
  if (isInvalid || (isList && typeof value !== 'object'))
    throw new WarpError(
      `The warp's uniform "${name}": expected ${isList ? 'an array of numbers' : 'a number'}, got ${describe(value)}.`,
    )
  const size = matrixSizes[type ?? 0] ?? (isList && items)
  if (size && Array.isArray(value) && !(value.length === size && value.every(Number.isFinite)))
    throw new WarpError(
      `The warp's uniform "${name}": expected an array of ${size} numbers${items < 5 ? '' : ', column by column'}, got ${describe(value)}.`,
    )
  // p5 1.11 accepts neither its own vectors nor its own colours as the value of a uniform.
  const list = isList && componentsOf(value as object)
  return items && isList ? Array.from(list as number[]).slice(0, items) : list || value
}
