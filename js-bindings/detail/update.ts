// The arguments of `update` of a divided mesh. Reading them creates no garbage, since that is done in each frame.
import type { Uniforms } from '../core/inputs/vertices.js'
import { anything, oneOf, optional, positiveNumber, record } from '../options/kinds.js'
import { copyNumbers, readNumbers } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'

/** A picture that shows the mesh: its camera and its size. */
export interface DetailView {
  /** Transforms warped positions into clip space: the product of the projection, view and model matrices, 16 numbers column by column. */
  readonly matrix: ArrayLike<number>
  /** The size of the viewport in pixels of the canvas. */
  readonly width: number
  readonly height: number
  /**
   * The sides of triangles that are drawn. Triangles that show only the other side are not divided.
   * @default 'both'
   */
  readonly side?: 'front' | 'back' | 'both'
}

export interface DetailUpdate {
  /** Uniforms of the warp, and its inputs such as `millis`. */
  readonly uniforms?: Uniforms
  /**
   * The max distance between the drawn triangles and the warped surface, in pixels. It is measured at samples: 99.9% of the surface are
   * closer, single points may not be.
   * @default 1
   */
  readonly tolerance?: number
}

export const updatePlace = new Place('update')
const viewPlace = updatePlace.argument(1)
const matrixPlace = updatePlace.option('matrix')

const updateOptions = object({
  uniforms: optional(record<Uniforms>('an object, such as { millis: 1200 },')),
  tolerance: positiveNumber({ default: 1 }),
} satisfies KindsOf<DetailUpdate>)

const facings = { front: 1, back: -1, both: 0 }
const sideKind = oneOf(['front', 'back', 'both'], 'both')
const viewOptions = object({
  matrix: anything<ArrayLike<number>>(),
  width: positiveNumber(),
  height: positiveNumber(),
  side: sideKind,
} satisfies KindsOf<DetailView>)

const viewKind = record<DetailView>('a view such as { matrix, width, height }')

export const noUniforms: Uniforms = {}

const updateNow = updateOptions.read({}, updatePlace)

/** Returns the options of the update. The next call overwrites them. */
export function readUpdate(options: DetailUpdate | undefined) {
  updateOptions.readInto(updateNow, options, updatePlace)
  return updateNow
}

/** The numbers of a view: see `DetailViews`. */
const numbersPerView = 19
const matrixNow = Array<number>(16).fill(0.5)
const viewNow = viewOptions.read({ width: 1, height: 1 }, updatePlace)

/** Replaces the numbers by those of the views. */
export function writeViews(numbers: number[], views: DetailView | readonly DetailView[]) {
  const isList = Array.isArray(views)
  const count = isList ? views.length : 1
  if (numbers.length > numbersPerView * count) numbers.length = numbersPerView * count
  for (let i = 0; i < count; i++)
    writeView(numbers, numbersPerView * i, isList ? (views as readonly DetailView[])[i]! : views)
}

function writeView(numbers: number[], at: number, given: unknown) {
  viewOptions.readInto(viewNow, viewKind.read(given, viewPlace), updatePlace)
  const { matrix, width, height, side } = viewNow
  if (!copyNumbers(matrixNow, matrix))
    readNumbers(matrixPlace, matrix, 16, { layout: ', column by column,' })
  for (let i = 0; i < 16; i++) numbers[at + i] = matrixNow[i]!
  numbers[at + 16] = width / 2
  numbers[at + 17] = height / 2
  numbers[at + 18] = facings[side]
}
