// Uniforms for the wrapping, the filter and the matrix of a texture of Babylon.js.
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import { Constants } from '@babylonjs/core/Engines/constants.js'
import { hostWraps, samplingUniforms } from '../core/expression/sampling.js'
import type { BabylonUniform } from './uniform.js'

const wrapNumbers: Record<number, number> = {
  [Constants.TEXTURE_CLAMP_ADDRESSMODE]: hostWraps.clamp,
  [Constants.TEXTURE_WRAP_ADDRESSMODE]: hostWraps.repeat,
  [Constants.TEXTURE_MIRROR_ADDRESSMODE]: hostWraps.mirror,
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

export function samplingOf(label: string, read: () => BaseTexture): BabylonUniform[] {
  const names = samplingUniforms(label)
  const settings = () => {
    const texture = read()
    const { samplingMode } = texture as { samplingMode?: number }
    return [
      wrapNumbers[texture.wrapU] ?? hostWraps.clamp,
      wrapNumbers[texture.wrapV] ?? hostWraps.clamp,
      Number(nearest.has(samplingMode ?? Constants.TEXTURE_LINEAR_LINEAR)),
    ]
  }
  // Babylon's shaders take the first two rows of matrix * vec4(u, v, 1, 0).
  const transform = () => {
    const m = read().getTextureMatrix().asArray()
    return [0, 4, 8].flatMap((column) => [m[column]!, m[column + 1]!, column / 8 === 1 ? 1 : 0])
  }
  return [
    { label: names.settings, shape: [1, 3], numbers: settings },
    { label: names.transform, shape: [3, 3], numbers: transform },
  ]
}
