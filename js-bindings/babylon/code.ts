// The code of a warp in the shaders of a material, for `getCustomCode` of a plugin.
import { fragmentCode } from './fragment-normals.js'
import { pixelTextsOf, type PixelTexts } from './pixel-normals.js'
import { vertexCode } from './shader.js'
import type { ShaderParts } from './uniforms.js'

export interface WarpCode {
  vertex: Record<string, string>
  fragment: Record<string, string>
  /** Missing for normals at vertices. */
  pixels: PixelTexts | undefined
  /** Equal code has the same number. */
  number: number
}

/** Maps the code of warps → its number. */
const numbers = new Map<string, number>()

function numberOf(code: string): number {
  if (!numbers.has(code)) numbers.set(code, numbers.size + 1)
  return numbers.get(code)!
}

export function codeOf(parts: ShaderParts, hasPixels: boolean, isWGSL: boolean): WarpCode {
  const pixels = hasPixels ? pixelTextsOf(parts, isWGSL) : undefined
  const vertex = vertexCode(parts, pixels, isWGSL)
  const fragment = fragmentCode(parts, pixels, isWGSL)
  return { vertex, fragment, pixels, number: numberOf(JSON.stringify([vertex, fragment])) }
}
