// A host's way to sample an image: wrapping and filter, which the adapter passes to the shader with the image.

/** The parts of the sampling that an adapter passes to the shader. */
export interface HostSampling {
  /** True if the host multiplies texture coordinates by a mat3 first. */
  hasTransform: boolean
}

/**
 * Returns the names of the uniforms for the sampling. `settings` is a vec3: the wrap numbers in u and in v, and 1 for the filter 'nearest'.
 */
export const samplingUniforms = (image: string) => ({
  settings: `${image}Sampling`,
  transform: `${image}Transform`,
})

/** Wrap numbers in `settings`. */
export const hostWraps = { clamp: 0, repeat: 1, mirror: 2 } as const
