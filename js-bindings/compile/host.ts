// The description of a host by its adapter.
import type { drawInputs } from '../core/inputs/inputs.js'
import type { ImageSampling } from './image-sampling.js'

export interface Host {
  /** The name in messages. */
  name: string
  /** The inputs of a draw call that the host has. An offset that reads another one throws. */
  inputs: readonly DrawInput[]
  /** Advice in messages about an input that the host lacks. Default: declare a uniform. */
  advice?: Partial<Record<DrawInput, string>>
  /** `true` if an offset may read other variables of the shader by `glsl.param`. */
  hasParameters?: boolean
  /** Uniforms in the shader are named by this prefix and a number, so that the user's names cannot collide. */
  prefix: string
  /** Present if uniforms can be set, and arrays can change in place. Otherwise arrays are copied. */
  values?: HostValues
  /** Present if the shader samples an image as the host does. */
  sampling?: {
    /** `true` if the host multiplies texture coordinates by a mat3 first. */
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
