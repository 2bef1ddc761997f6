// The description of a host, by which its adapter says where it differs from others.
import type { drawInputs } from '../core/inputs/inputs.js'
import type { ImageSampling } from './image-sampling.js'

export interface Host {
  /** Its name in messages. */
  name: string
  /** The inputs of a draw call that it has. An offset that reads another one throws. */
  inputs: readonly DrawInput[]
  /** Advice for messages about an input that it lacks. Default: declare a uniform. */
  advice?: Partial<Record<DrawInput, string>>
  /** `true` if an offset may read other variables of the shader by `glsl.param`. */
  hasParameters?: boolean
  /** Uniforms are named by this and a number, so that users may name them as they like. */
  prefix: string
  /** Present if uniforms may be set, and their values change in place. Otherwise lists are copied. */
  values?: HostValues
  /** Present if the shader knows how the host samples an image. */
  sampling?: {
    /** `true` if the host multiplies texture coordinates by a mat3 first. */
    hasTransform: boolean
    /** Missing if the adapter sets the uniforms of the sampling itself. */
    read?: (image: never) => ImageSampling
  }
}

export type DrawInput = keyof typeof drawInputs

/** Values of the host's own classes. */
export interface HostValues {
  isImage: (value: unknown) => boolean
  /** The numbers of a vector, colour or matrix; anything else as it is. */
  toNumbers: (value: unknown) => unknown
}
