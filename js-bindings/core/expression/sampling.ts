// The sampling of an image by its host, which the adapter passes to the shader beside the image.

/** The sampling that an adapter passes to the shader beside an image. */
export interface HostSampling {
  /** `true` if the host multiplies texture coordinates by a mat3 first. */
  hasTransform: boolean
}

/** Names of the uniforms that carry it. `settings` is a vec3: the wrap number in u, the one in v, and 1 for the filter 'nearest'. */
export const samplingUniforms = (image: string) => ({
  settings: `${image}Sampling`,
  transform: `${image}Transform`,
})

/** Wrap numbers in `settings`. */
export const hostWraps = { clamp: 0, repeat: 1, mirror: 2 } as const
