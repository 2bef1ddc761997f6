// Reads values of Babylon.js: the sampling of textures, and the numbers of vectors, colours and matrices.
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

/**
 * Returns the numbers of a colour (with r, g and b, and for a Color4 a), a Matrix (with its numbers in m) or a vector (with x and y at
 * least), and other values unchanged.
 */
function toNumbers(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value
  const { r, g, b, a, m, x, y, z, w } = value as Record<string, unknown>
  if (r !== undefined && b !== undefined) return a === undefined ? [r, g, b] : [r, g, b, a]
  if (m !== undefined) return m
  return 'x' in value ? [x, y, z, w].filter((component) => component !== undefined) : value
}

const wraps: Record<number, Wrap> = {
  [Constants.TEXTURE_CLAMP_ADDRESSMODE]: 'clamp',
  [Constants.TEXTURE_WRAP_ADDRESSMODE]: 'repeat',
  [Constants.TEXTURE_MIRROR_ADDRESSMODE]: 'mirror',
}

/** The sampling modes whose magnification filter is nearest. */
const nearestModes: ReadonlySet<number> = new Set([
  Constants.TEXTURE_NEAREST_NEAREST,
  Constants.TEXTURE_NEAREST_LINEAR,
  Constants.TEXTURE_NEAREST_NEAREST_MIPNEAREST,
  Constants.TEXTURE_NEAREST_NEAREST_MIPLINEAR,
  Constants.TEXTURE_NEAREST_LINEAR_MIPNEAREST,
  Constants.TEXTURE_NEAREST_LINEAR_MIPLINEAR,
])

function samplingOf(texture: BaseTexture): ImageSampling {
  const { samplingMode } = texture as { samplingMode?: number }
  // Babylon's shaders compute the coordinates as the first two components of matrix * vec4(u, v, 1, 0).
  const m = texture.getTextureMatrix().asArray()
  return {
    wrap: [wraps[texture.wrapU] ?? 'clamp', wraps[texture.wrapV] ?? 'clamp'],
    isNearest: nearestModes.has(samplingMode ?? Constants.TEXTURE_LINEAR_LINEAR),
    transform: [0, 4, 8].flatMap((first) => [m[first]!, m[first + 1]!, first === 8 ? 1 : 0]),
  }
}
