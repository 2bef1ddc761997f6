/**
 * Adds the normals of a warp to the fragment shaders of WebGLRenderer. Three.js reads the interpolated normal in one line of its chunk
 * `normal_fragment_begin`, which we replace. Everything after it, such as both sides, maps, clearcoats and lights, uses the new normal.
 */
import { declareFacing, markViewPosition, type PixelNormals } from './pixel-normals.js'
import { chunkSource, resolveIncludes, splitAtMain } from './shader-source.js'

const normalLine = /\bvec3\s+normal\s*=\s*normalize\s*\(\s*vNormal\s*\)\s*;/g

/** Splits a fragment shader before `main`; returns `undefined` unless `main` contains the line once. */
function splitAtLine(fragmentShader: string) {
  const parts = splitAtMain(resolveIncludes(fragmentShader))
  return parts?.main.match(normalLine)?.length === 1 ? parts : undefined
}

/** Tests whether a fragment shader has the line, so that it can compute normals. */
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
    .replace(normalLine, 'vec3 normal = warpjetNormalOfPixel();')
    .replace(/\bnormalize\(\s*vTangent\s*\)/g, 'warpjetTangentOfPixel')
    .replace(/\bnormalize\(\s*vBitangent\s*\)/g, 'warpjetBitangentOfPixel')
  return `${markViewPosition(top)}
#ifndef FLAT_SHADED
${pixel.declarations(precision, isMatrixDeclared)}
#endif
${woven}`
}

/**
 * If normals are computed at vertices: makes a fragment shader light a triangle that the warp collapses by its geometric normal; see
 * `avoidNaN` in warp-block.ts. A shader without the position in view space lights such a triangle as if it faced the eye.
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
${parts.main.replace(normalLine, 'vec3 normal = warpjetNormalOfPixel();')}`
}
