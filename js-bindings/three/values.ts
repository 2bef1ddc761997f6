// Converts values of three.js for a warp: textures, and the numbers of vectors, colours and matrices.
import {
  MirroredRepeatWrapping,
  NearestFilter,
  RepeatWrapping,
  type Color,
  type Matrix4,
  type Texture,
  type Vector4,
  type Wrapping,
} from 'three'
import type { Host, ImageSampling, Wrap } from '../compile/hosts.js'

export const three: Host = {
  name: 'three.js',
  inputs: ['millis'],
  advice: {
    instance:
      "place instances by their matrices, and warp in the space 'world', where each is at a place of its own",
  },
  prefix: 'warpjet',
  values: {
    isImage: (value) => (value as Partial<Texture> | undefined | null)?.isTexture === true,
    toNumbers,
  },
  sampling: { hasTransform: true, read: samplingOf },
}

function toNumbers(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value
  const object = value as Partial<Vector4 & Color & Matrix4>
  if (Array.isArray(object.elements)) return object.elements
  if (object.isColor) return [object.r, object.g, object.b]
  if ('x' in object && 'y' in object)
    return [object.x, object.y, object.z, object.w].filter((component) => component !== undefined)
  return value
}

function wrapOf(wrapping: Wrapping): Wrap {
  if (wrapping === RepeatWrapping) return 'repeat'
  return wrapping === MirroredRepeatWrapping ? 'mirror' : 'clamp'
}

/** Returns the sampling of a texture. `transform` is the matrix of the texture's `offset`, `repeat` and `rotation`. */
function samplingOf(texture: Texture): ImageSampling {
  if (texture.matrixAutoUpdate) texture.updateMatrix()
  return {
    wrap: [wrapOf(texture.wrapS), wrapOf(texture.wrapT)],
    isNearest: texture.magFilter === NearestFilter,
    transform: texture.matrix.elements,
  }
}
