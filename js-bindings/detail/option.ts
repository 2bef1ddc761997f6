// The option `detail`.
import { describe } from '../errors/errors.js'
import { boolean, type Kind } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'

/** A number of pixels above 0, or `'auto'`, which is 1, or 2 on devices that are used by touch. */
export type DetailTolerance = number | 'auto'

export interface DetailOptions {
  /**
   * The maximum distance, in pixels of the canvas, between the drawn triangles and the warped surface.
   * @default 'auto'
   */
  tolerance?: DetailTolerance
  /**
   * `true` rounds the mesh before it is warped: its triangles become curved ones that meet at the vertices, at right angles to the
   * normals there (PN triangles: Vlachos et al., "Curved PN Triangles", 2001). A coarse sphere gets a round silhouette; a box, whose
   * normals differ along its edges, stays a box. Meshes without normals stay flat.
   * @default false
   */
  curved?: boolean
}

/** The maximum distance between the drawn triangles and the warped surface, or all options. `false` draws the mesh with its own vertices. */
export type DetailOption = DetailTolerance | DetailOptions | false

/** The option as it was read. */
export interface DetailSettings {
  /** In pixels. */
  readonly tolerance: number
  readonly isCurved: boolean
}

const toleranceKind: Kind<number, DetailTolerance> = {
  read(given = 'auto', place) {
    if (given === 'auto') return hasCoarsePointer() ? 2 : 1
    if (isTolerance(given)) return given
    throw place.expected("a number of pixels above 0 or 'auto'", describe(given))
  },
}

const options = object({
  tolerance: toleranceKind,
  curved: boolean(false),
} satisfies KindsOf<DetailOptions>)

/** Reads the option; `false` becomes `undefined`. */
export const detailKind: Kind<DetailSettings | undefined, DetailOption> = {
  read(given, place) {
    if (given === undefined || given === false) return undefined
    const { tolerance, curved } = options.read(optionsOf(given, place), place)
    return { tolerance, isCurved: curved }
  },
}

function optionsOf(given: unknown, place: Place): DetailOptions {
  if (given === 'auto' || isTolerance(given)) return { tolerance: given }
  if (typeof given === 'object' && given !== null) return given
  throw place.expected(
    "a number of pixels above 0, 'auto', false or { tolerance, curved }",
    describe(given),
  )
}

const isTolerance = (given: unknown): given is number =>
  typeof given === 'number' && given > 0 && Number.isFinite(given)

const hasCoarsePointer = () => globalThis.matchMedia?.('(pointer: coarse)').matches ?? false
