// The description of a host, which its adapter passes to the compiler.
import type { drawInputs } from '../core/inputs/inputs.js'
import type { ImageSampling } from './image-sampling.js'

export interface Host {
  /** The name in messages. */
  name: string
  /** The draw inputs (`millis`, `mouse` …) that the host provides. An offset that reads any other throws. */
  inputs: readonly DrawInput[]
  /** Advice in messages about an input that the host lacks. Default: declare a uniform. */
  advice?: Partial<Record<DrawInput, string>>
  /** True if an offset may read other variables of the shader by `glsl.param`. */
  hasParameters?: boolean
  /** The prefix of the names of uniforms in the shader; a number follows. So the names cannot collide with the user's. */
  prefix: string
  /**
   * Present if uniforms can be set after compilation; then uniform arrays, which may change in place, are read anew for each draw. If
   * absent, arrays are copied once.
   */
  values?: HostValues
  /** Present if warps in the shader sample an image with the host's wrapping and filter. */
  sampling?: {
    /** True if the host multiplies texture coordinates by a mat3 first. */
    hasTransform: boolean
    /** Missing if the adapter itself sets the uniforms for the sampling. */
    read?: (image: never) => ImageSampling
  }
}

export type DrawInput = keyof typeof drawInputs

/** Reads values of the host's own classes. */
export interface HostValues {
  isImage: (value: unknown) => boolean
  /** Returns the numbers of a vector, colour or matrix, and any other value unchanged. */
  toNumbers: (value: unknown) => unknown
}
