// Describes how a host samples an image, in uniforms.
import { hostWraps, samplingUniforms } from '../core/expression/sampling.js'

export { samplingUniforms }

export interface ImageSampling {
  /** The wrapping in u and v. */
  wrap: readonly [Wrap, Wrap]
  /** `true` if the filter returns the nearest texel. */
  isNearest: boolean
  /** The mat3 by which texture coordinates are multiplied, column by column. Present if the host has one. */
  transform?: readonly number[]
}

/** A mode of wrapping. Other modes of a host are treated as `'clamp'`. */
export type Wrap = keyof typeof hostWraps

/** Returns the numbers of the uniform `samplingUniforms(…).settings`. */
export const samplingNumbers = ({ wrap: [u, v], isNearest }: ImageSampling): number[] => [
  hostWraps[u],
  hostWraps[v],
  Number(isNearest),
]
