// Reads wrapping and filter of a p5.Texture as the numbers of a uniform; see `samplingUniforms`.
import { hostWraps } from '../core/expression/sampling.js'

/** p5.Texture, as far as a warp reads it. p5 1.11 keeps WebGL's numbers, p5 2 its own words. */
export interface Texture {
  readonly width: number
  readonly height: number
  readonly wrapS?: string
  readonly wrapT?: string
  readonly magFilter?: string
  readonly glWrapS?: number
  readonly glWrapT?: number
  readonly glMagFilter?: number
}

const glRepeat = 0x2901
const glMirroredRepeat = 0x8370
const glNearest = 0x2600

function wrapNumber(wrap: string | number | undefined) {
  if (wrap === 'repeat' || wrap === glRepeat) return hostWraps.repeat
  return wrap === 'mirror' || wrap === glMirroredRepeat ? hostWraps.mirror : hostWraps.clamp
}

export function samplingNumbers(texture: Texture): number[] {
  const magFilter = texture.magFilter ?? texture.glMagFilter
  return [
    wrapNumber(texture.wrapS ?? texture.glWrapS),
    wrapNumber(texture.wrapT ?? texture.glWrapT),
    Number(magFilter === 'nearest' || magFilter === glNearest),
  ]
}
