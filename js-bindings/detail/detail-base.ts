// The mesh that is divided, as adapters pass it.
import type { Vertices } from '../core/inputs/vertices.js'

export interface DetailAttribute {
  /** The input array of the warp that this attribute is; missing if it is none. */
  readonly input?: Exclude<keyof Vertices, 'positions'> | undefined
  /** Numbers per vertex. */
  readonly size: number
  readonly values: ArrayLike<number>
  /** `true` for unit vectors, which keep their length between vertices. */
  readonly isUnit?: boolean
}

export interface DetailBase {
  /** 3 numbers per vertex. */
  readonly positions: ArrayLike<number>
  readonly attributes: readonly DetailAttribute[]
  /** 3 per triangle. */
  readonly indices: ArrayLike<number>
  /** The indices of the triangles at which groups begin, in ascending order. */
  readonly groups?: readonly number[]
  /** `true` makes the surface between vertices of curved triangles, if an attribute has unit vectors. */
  readonly isCurved?: boolean
}
