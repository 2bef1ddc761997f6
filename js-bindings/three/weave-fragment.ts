/**
 * Puts the normals of a warp into the fragment shaders of WebGLRenderer. Three.js reads the interpolated normal in one line of its chunk
 * `normal_fragment_begin`. Everything after that line, such as both sides, maps, clearcoats and lights, follows from a change of it.
 */
import { declareFacing, markViewPosition, type PixelNormals } from './pixel-normals.js'
import { chunkSource, resolveIncludes, splitAtMain } from './shader-source.js'

const line = /\bvec3\s+normal\s*=\s*normalize\s*\(\s*vNormal\s*\)\s*;/g

/** Splits a fragment shader in front of `main` if the line is in it. */
function splitAtLine(fragmentShader: string) {
  const parts = splitAtMain(resolveIncludes(fragmentShader))
  return parts?.main.match(line)?.length === 1 ? parts : undefined
}

/** Tests whether normals can be computed in a fragment shader. */
export const hasNormalLine = (fragmentShader: string) => splitAtLine(fragmentShader) !== undefined

export const readsVaryingNormal = (fragmentShader: string) =>
  /\bvNormal\b/.test(resolveIncludes(fragmentShader))

/** Replaces the interpolated normal by that of the pixel. */
export function weavePixelNormals(
  fragmentShader: string,
  pixel: PixelNormals,
  precision: string,
): string {
  const { top, main } = splitAtLine(fragmentShader)!
  const others = top.replace(chunkSource('normalmap_pars_fragment'), '')
  const isMatrixDeclared = /\buniform\b[^;]*\bnormalMatrix\b/.test(others)
  const woven = main
    .replace(line, 'vec3 normal = warpjetNormalOfPixel();')
    .replace(/\bnormalize\(\s*vTangent\s*\)/g, 'warpjetTangentOfPixel')
    .replace(/\bnormalize\(\s*vBitangent\s*\)/g, 'warpjetBitangentOfPixel')
  return `${markViewPosition(top)}
#ifndef FLAT_SHADED
${pixel.declarations(precision, isMatrixDeclared)}
#endif
${woven}`
}

/**
 * Lights a triangle that the warp collapses by its geometric normal, where normals are those of vertices: see `avoidNaN` in warp-block.ts.
 * Shaders without a position in view space light it as if it faced the eye.
 */
export function weaveVertexNormals(fragmentShader: string): string {
  const parts = splitAtLine(fragmentShader)
  if (!parts) return fragmentShader
  return `${markViewPosition(parts.top)}
#if ! defined( FLAT_SHADED ) && defined( WARPJET_VIEW_POSITION )
${declareFacing}
vec3 warpjetNormalOfPixel() {
vec3 warpjetFacingNormal = warpjetFacing();
return dot( vNormal, vNormal ) > 1e-10 ? normalize( vNormal ) : warpjetFacingNormal;
}
#else
#define warpjetNormalOfPixel() normalize( vNormal )
#endif
${parts.main.replace(line, 'vec3 normal = warpjetNormalOfPixel();')}`
}
