// The option `detail`.
import { describe } from '../errors/errors.js'
import type { Kind } from '../options/kinds.js'

/**
 * The maximum distance, in pixels of the canvas, between the drawn triangles and the warped surface. `'auto'` is 1, or 2 on devices that
 * are used by touch. `false` draws the mesh with its own vertices.
 */
export type DetailOption = number | 'auto' | false

/** Reads the option as a number of pixels, or `undefined` for `false`. */
export const detailKind: Kind<number | undefined, DetailOption> = {
  read(given, place) {
    if (given === undefined || given === false) return undefined
    if (given === 'auto') return hasCoarsePointer() ? 2 : 1
    if (typeof given === 'number' && given > 0 && Number.isFinite(given)) return given
    throw place.expected("a number of pixels above 0, 'auto' or false", describe(given))
  },
}

const hasCoarsePointer = () => globalThis.matchMedia?.('(pointer: coarse)').matches ?? false
