// The sampling of an image, as the numbers of uniforms.
import { hostWraps, samplingUniforms } from '../core/expression/sampling.js'

export { samplingUniforms }

export interface ImageSampling {
  /** In u and v. */
  wrap: readonly [Wrap, Wrap]
  /** `true` if the filter takes the nearest texel. */
  isNearest: boolean
  /** The mat3 for texture coordinates, column by column, where the host has one. */
  transform?: readonly number[]
}

/** Other ways of the host count as `'clamp'`. */
export type Wrap = keyof typeof hostWraps

/** The numbers of the uniform `settings`. */
export const samplingNumbers = ({ wrap: [u, v], isNearest }: ImageSampling): number[] => [
  hostWraps[u],
  hostWraps[v],
  Number(isNearest),
]
