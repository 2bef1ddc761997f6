// Values of three.js, as a warp has them: textures, and the numbers of vectors, colours and matrices.
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
  const it = value as Partial<Vector4 & Color & Matrix4>
  if (Array.isArray(it.elements)) return it.elements
  if (it.isColor) return [it.r, it.g, it.b]
  if ('x' in it && 'y' in it) return [it.x, it.y, it.z, it.w].filter((part) => part !== undefined)
  return value
}

function wrapOf(wrapping: Wrapping): Wrap {
  if (wrapping === RepeatWrapping) return 'repeat'
  return wrapping === MirroredRepeatWrapping ? 'mirror' : 'clamp'
}

/** The transform is the matrix of the texture's `offset`, `repeat` and `rotation`. */
function samplingOf(texture: Texture): ImageSampling {
  if (texture.matrixAutoUpdate) texture.updateMatrix()
  return {
    wrap: [wrapOf(texture.wrapS), wrapOf(texture.wrapT)],
    isNearest: texture.magFilter === NearestFilter,
    transform: texture.matrix.elements,
  }
}
