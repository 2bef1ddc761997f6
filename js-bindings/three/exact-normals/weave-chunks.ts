/**
 * Adds exact normals to vertex shaders that compute normals by three.js' own chunks. The shader still moves the vertex by itself. Before
 * `mvPosition` is computed, when all displacement is done, three.js' lines for normals run a second time, with the transformed normal.
 */
import { markViewPosition, type PixelNormals } from '../pixel-normals.js'
import { chunkSource, resolveIncludes } from '../shader-source.js'
import { atObject, toView } from '../warp-block.js'
import { WarpCode } from '../warp-code.js'
import type { WeaveOptions } from '../weave-options.js'
import {
  anchor,
  markNormals,
  markVaryings,
  passToPixels,
  projection,
  splitAtAnchor,
} from '../weave.js'
import type { Displacement } from './displacement.js'

/** Tests whether three.js' own lines compute the normal of a shader. */
export const makesNormal = (vertexShader: string) => {
  const { main = '' } = splitAtAnchor(resolveIncludes(vertexShader)) ?? {}
  return /\btransformedNormal\b/.test(main)
}

/** Returns why normals cannot be computed in the fragment shader; `undefined` if they can. */
export function obstacleInChunks(vertexShader: string): string | undefined {
  const { main = '' } = splitAtAnchor(resolveIncludes(vertexShader)) ?? {}
  return makesNormal(vertexShader) && projection.test(main.slice(anchor.exec(main)?.index))
    ? undefined
    : "its vertex shader lacks three's lines for normals, or gl_Position = projectionMatrix * mvPosition;"
}

export function weaveChunks(
  vertexShader: string,
  { warp }: Displacement,
  options: Pick<WeaveOptions, 'mayHaveTangents' | 'hasColors'>,
  pixel?: PixelNormals,
): string {
  const { top, main } = splitAtAnchor(resolveIncludes(vertexShader))!
  const code = new WarpCode(warp, { ...options, isLit: true })
  const start = anchor.exec(main)!.index
  const before = main.slice(0, start)
  const after = main.slice(start)
  const isRest = warp.settings.space === 'rest'
  const marked = markVaryings(top)
  return `${pixel ? markViewPosition(marked) : marked}
${code.declarations}
${pixel ? pixel.varyings : ''}
${markNormals(isRest ? before : storePosedPosition(before))}
${normalBlock(code, pixel)}
${pixel ? passToPixels(after, pixel) : after}`
}

/** Stores the position after morph targets and bones, where a displacement after them starts. */
const storePosedPosition = (before: string) =>
  before.replace(skinningChunk(), (chunk) => `${chunk}\nvec3 warpjetStart = transformed;\n`)

const skinningChunk = () => chunkSource('skinning_vertex')

function normalBlock(code: WarpCode, pixel: PixelNormals | undefined): string {
  const isRest = code.warp.settings.space === 'rest'
  const pose = ['morphnormal_vertex', 'skinnormal_vertex'].map(chunkSource).join('\n')
  const { code: statements, ...surface } = code.evaluate(
    isRest ? 'vec3( position )' : 'warpjetStart',
    isRest ? { normal: 'vec3( normal )', tangent: 'tangent.xyz' } : atObject,
  )
  return `#if defined( WARPJET_OBJECT_NORMAL ) && defined( WARPJET_TRANSFORMED_NORMAL )
{
${isRest ? '' : `${chunkSource('beginnormal_vertex')}\n${pose}`}
${code.preparation}${statements}
${pixel ? pixel.pass(code.names) : ''}
vec3 warpjetViewNormal;
${toView(code, surface, true, isRest ? pose : '')}
transformedNormal = warpjetViewNormal;
}
#endif`
}
