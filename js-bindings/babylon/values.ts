// Converts values of Babylon.js: textures, and vectors, colours and matrices to numbers.
import { Constants } from '@babylonjs/core/Engines/constants.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { Host, ImageSampling, Wrap } from '../compile/hosts.js'

export const babylon: Host = {
  name: 'Babylon.js',
  inputs: ['millis'],
  prefix: 'warpjet',
  values: { isImage: isTexture, toNumbers },
  sampling: { hasTransform: true, read: samplingOf },
}

function isTexture(value: unknown): boolean {
  return typeof (value as Partial<BaseTexture> | undefined)?.getInternalTexture === 'function'
}

/** A Color3 has r, g and b, a vector x and y, and a Matrix its numbers. */
function toNumbers(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value
  const { r, g, b, a, m, x, y, z, w } = value as Record<string, unknown>
  if (r !== undefined && b !== undefined) return a === undefined ? [r, g, b] : [r, g, b, a]
  if (m !== undefined) return m
  return 'x' in value ? [x, y, z, w].filter((part) => part !== undefined) : value
}

const wraps: Record<number, Wrap> = {
  [Constants.TEXTURE_CLAMP_ADDRESSMODE]: 'clamp',
  [Constants.TEXTURE_WRAP_ADDRESSMODE]: 'repeat',
  [Constants.TEXTURE_MIRROR_ADDRESSMODE]: 'mirror',
}

/** The sampling modes whose magnification takes the nearest texel. */
const nearest: ReadonlySet<number> = new Set([
  Constants.TEXTURE_NEAREST_NEAREST,
  Constants.TEXTURE_NEAREST_LINEAR,
  Constants.TEXTURE_NEAREST_NEAREST_MIPNEAREST,
  Constants.TEXTURE_NEAREST_NEAREST_MIPLINEAR,
  Constants.TEXTURE_NEAREST_LINEAR_MIPNEAREST,
  Constants.TEXTURE_NEAREST_LINEAR_MIPLINEAR,
])

function samplingOf(texture: BaseTexture): ImageSampling {
  const { samplingMode } = texture as { samplingMode?: number }
  // Babylon's shaders take the first two rows of matrix * vec4(u, v, 1, 0).
  const m = texture.getTextureMatrix().asArray()
  return {
    wrap: [wraps[texture.wrapU] ?? 'clamp', wraps[texture.wrapV] ?? 'clamp'],
    isNearest: nearest.has(samplingMode ?? Constants.TEXTURE_LINEAR_LINEAR),
    transform: [0, 4, 8].flatMap((column) => [
      m[column]!,
      m[column + 1]!,
      column / 8 === 1 ? 1 : 0,
    ]),
  }
}
