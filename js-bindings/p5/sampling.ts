// Reads the wrap mode and the filter of a p5.Texture.
import type { ImageSampling, Wrap } from '../compile/hosts.js'

/** The members of a p5.Texture that a warp reads. p5 1.11 stores WebGL enums, p5 2 stores words of its own. */
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

function wrapOf(wrap: string | number | undefined): Wrap {
  if (wrap === 'repeat' || wrap === glRepeat) return 'repeat'
  return wrap === 'mirror' || wrap === glMirroredRepeat ? 'mirror' : 'clamp'
}

export function samplingOf(texture: Texture): ImageSampling {
  const magFilter = texture.magFilter ?? texture.glMagFilter
  return {
    wrap: [wrapOf(texture.wrapS ?? texture.glWrapS), wrapOf(texture.wrapT ?? texture.glWrapT)],
    isNearest: magFilter === 'nearest' || magFilter === glNearest,
  }
}
