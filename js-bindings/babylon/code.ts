// The code of a warp for the shaders of a material, as `getCustomCode` of a plugin returns it.
import { fragmentCode } from './fragment-normals.js'
import { pixelTextsOf, type PixelTexts } from './pixel-normals.js'
import { vertexCode } from './shader.js'
import type { ShaderParts } from './uniforms.js'

export interface WarpCode {
  vertex: Record<string, string>
  fragment: Record<string, string>
  /** The code of normals at pixels; `undefined` for normals at vertices. */
  pixels: PixelTexts | undefined
  /** Identifies the code: warps with equal code have the same number. */
  number: number
}

/** Maps the code of warps → its number. */
const codeNumbers = new Map<string, number>()

function numberOf(code: string): number {
  if (!codeNumbers.has(code)) codeNumbers.set(code, codeNumbers.size + 1)
  return codeNumbers.get(code)!
}

export function codeOf(parts: ShaderParts, hasPixels: boolean, isWGSL: boolean): WarpCode {
  const pixels = hasPixels ? pixelTextsOf(parts, isWGSL) : undefined
  const vertex = vertexCode(parts, pixels, isWGSL)
  const fragment = fragmentCode(parts, pixels, isWGSL)
  return { vertex, fragment, pixels, number: numberOf(JSON.stringify([vertex, fragment])) }
}
