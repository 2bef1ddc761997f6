// The sampling of an image by its host, as uniforms.
import { hostWraps, samplingUniforms } from '../core/expression/sampling.js'

export { samplingUniforms }

export interface ImageSampling {
  /** The wrapping in u and v. */
  wrap: readonly [Wrap, Wrap]
  /** `true` if the filter returns the nearest texel. */
  isNearest: boolean
  /** Present if the host has one: the mat3 for texture coordinates, column by column. */
  transform?: readonly number[]
}

/** Other modes of a host count as `'clamp'`. */
export type Wrap = keyof typeof hostWraps

/** Returns the numbers of the uniform `settings`. */
export const samplingNumbers = ({ wrap: [u, v], isNearest }: ImageSampling): number[] => [
  hostWraps[u],
  hostWraps[v],
  Number(isNearest),
]
