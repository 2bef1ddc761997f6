/**
 * Adds a warp to the vertex shaders of WebGLRenderer without moving any lines that are not three's own.
 *
 * Three.js computes the normal before the position. So we insert the warp where the position is finished, before `mvPosition`, and
 * transform the normals that exist by then. If only three's own lines compute the normal, we warp `objectNormal` and run these lines
 * after that instead. If other code changes a normal, we transform that normal back from view space to the object, warp it, and transform
 * it to view space again.
 */
import { markViewPosition, passViewPosition, type PixelNormals } from './pixel-normals.js'
import { chunkSource, resolveIncludes, splitAtMain } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'
import { atObject, orientBitangent, warpBlock } from './warp-block.js'
import { WarpCode } from './warp-code.js'
import { readsNormal, readsPosition, weaveAttributes, wrapMain } from './weave-attributes.js'
import type { WeaveOptions } from './weave-options.js'

/** Matches the first statement that uses the finished position of the vertex. */
export const anchor = /\b(?:vec4\s+mvPosition|gl_Position)\s*=[^;]*\btransformed\b[^;]*;/

/** Tests whether a warp can be added to a vertex shader. */
export function canWeave(vertexShader: string): boolean {
  const source = resolveIncludes(vertexShader)
  return anchor.test(source) || readsPosition(splitAtMain(source)?.main ?? '')
}

/** Splits a source before the function that contains the anchor. That need not be `main`, which may call it. */
export function splitAtAnchor(source: string) {
  const { index } = anchor.exec(source) ?? {}
  if (index === undefined) return undefined
  const heads = [...source.slice(0, index).matchAll(/\bvoid\s+\w+\s*\([^)]*\)\s*\{/g)]
  const start = heads.at(-1)?.index
  return start === undefined
    ? undefined
    : { top: source.slice(0, start), main: source.slice(start) }
}

/** Returns a vertex shader with the warp. If `pixel` is passed, the shader also passes the varyings from which pixels compute normals. */
export function weave(
  vertexShader: string,
  warp: ThreeWarp,
  options: WeaveOptions,
  pixel?: PixelNormals,
): string {
  const source = resolveIncludes(vertexShader)
  const parts = splitAtAnchor(source)
  if (!parts) return weaveAttributes(source, warp, options)
  const isLit = /\btransformedNormal\b/.test(parts.main)
  // True for a shader that computes its own normal from the attribute.
  const readsAttribute =
    !isLit && options.isShaderMaterial && readsNormal(withoutNormalChunks(source))
  const code = new WarpCode(warp, {
    isLit: isLit || readsAttribute,
    mayHaveTangents: isLit && options.mayHaveTangents,
    hasColors: options.hasColors,
    target: options.isGlsl100 ? 'glsl100' : 'glsl300',
  })
  const start = anchor.exec(parts.main)!.index
  const before = parts.main.slice(0, start)
  const isRest = warp.settings.space === 'rest'
  const isStock = isUnchanged(before)
  const block = warpBlock(code, isLit, isStock, pixel)
  const kept = isStock ? withoutFirstRun(before) : before
  const after = parts.main.slice(start)
  const main = `${markNormals(isRest ? weaveAtRest(before, code, isLit, block, pixel) : kept)}
${isRest ? once('WARPJET_POSITION_DONE', block) : block}
${isRest ? afterPose(warp) : ''}${pixel ? passToPixels(after, pixel) : after}`
  const top = markVaryings(parts.top)
  if (readsAttribute) return wrapMain(`${top}\n${main}`, code, ['normal'], options)
  const declarations = pixel ? `${code.declarations}\n${pixel.varyings}` : code.declarations
  return `${pixel ? markViewPosition(top) : top}\n${declarations}\n${main}`
}

const assignment = /\b(?:vNormal|vTangent|vBitangent)\s*(?:\.\w+\s*)?[-+*/]?=(?!=)/

export const projection = /\bgl_Position\s*=\s*projectionMatrix\s*\*\s*mvPosition\s*;/

export const passToPixels = (after: string, pixel: PixelNormals) =>
  `${pixel.passMatrices}\n${after.replace(projection, `$&\n${passViewPosition}`)}`

/** Returns why normals cannot be computed in the fragment shader; `undefined` if they can. */
export function obstacleInVertex(vertexShader: string): string | undefined {
  const source = resolveIncludes(vertexShader)
  const { main = '' } = splitAtAnchor(source) ?? {}
  const before = main.slice(0, anchor.exec(main)?.index)
  if (
    !/\btransformedNormal\b/.test(main) ||
    !isUnchanged(before) ||
    assignment.test(withoutNormalChunks(source))
  )
    return 'its vertex shader changes normals by statements that three.js does not have'
  return projection.test(main)
    ? undefined
    : "its vertex shader lacks three's line gl_Position = projectionMatrix * mvPosition;"
}

/** Defines macros for the variables that exist, also where their declarations depend on conditions of the preprocessor. */
export const markNormals = (main: string) =>
  main
    .replace(/\bvec3\s+objectNormal\s*=[^;]*;/g, '$&\n#define WARPJET_OBJECT_NORMAL\n')
    .replace(/\bvec3\s+transformedNormal\s*=[^;]*;/g, '$&\n#define WARPJET_TRANSFORMED_NORMAL\n')

export const markVaryings = (top: string) =>
  top.replace(/\b(?:varying|out)\s+vec3\s+vNormal\s*;/g, '$&\n#define WARPJET_VARYING_NORMAL\n')

const normalNames =
  /\b(?:objectNormal|transformedNormal|vNormal|objectTangent|transformedTangent|vTangent|vBitangent)\b/

/** Tests whether only three's own chunks compute the normal. */
const isUnchanged = (main: string) => !normalNames.test(withoutNormalChunks(main))

export function withoutNormalChunks(source: string): string {
  const names = ['beginnormal', 'morphnormal', 'skinnormal', 'defaultnormal', 'normal']
  const chunks = [...names, 'displacementmap'].map((name) => chunkSource(`${name}_vertex`))
  return chunks.reduce((text, chunk) => (chunk ? text.replaceAll(chunk, '') : text), source)
}

/** Removes three's own lines that transform the normal of the object to the view, since they run after the warp instead. */
const withoutFirstRun = (main: string) =>
  main
    .replace(chunkSource('defaultnormal_vertex'), 'vec3 transformedNormal = vec3( 0.0 );')
    .replace(chunkSource('normal_vertex'), '')

/** Inserts the warp before morph targets and bones. */
function weaveAtRest(
  before: string,
  code: WarpCode,
  isLit: boolean,
  block: string,
  pixel: PixelNormals | undefined,
): string {
  const { code: statements, normal, tangent } = code.evaluate('warpjetStart', atObject)
  const normals = `vec3 warpjetRestObjectNormal = objectNormal;
{
vec3 warpjetStart = vec3( position );
${code.preparation}${statements}
${pixel ? `${pixel.pass(code.names)}\n` : ''}objectNormal = ${normal};
#ifdef USE_TANGENT
objectTangent = ${tangent};
#endif
}`
  const insertBefore = (text: string, statement: RegExp, inserted: string) =>
    text.replace(statement, (found) => `${inserted}\n${found}`)
  let text = before
  for (const statement of [
    /\bobjectNormal\s*\*=\s*morphTargetBaseInfluence/,
    /\bmat4\s+skinMatrix\s*=/,
  ])
    if (isLit) text = insertBefore(text, statement, once('WARPJET_NORMAL_DONE', normals))
  for (const statement of [
    /\btransformed\s*\*=\s*morphTargetBaseInfluence/,
    /\bvec4\s+skinVertex\s*=/,
  ])
    text = insertBefore(text, statement, once('WARPJET_POSITION_DONE', block))
  return text
}

const once = (mark: string, statements: string) =>
  `\n#ifndef ${mark}\n#define ${mark}\n${statements}\n#endif`

/**
 * Returns statements that complete the normal and the bitangent, which three's own lines compute from a normal that was warped before the
 * bones.
 */
const afterPose = (
  warp: ThreeWarp,
) => `#if defined( WARPJET_NORMAL_DONE ) && defined( WARPJET_VARYING_NORMAL )
if ( transformedNormal == vec3( 0.0 ) ) vNormal = vec3( 0.0, 0.0, 1e-6 );
${orientBitangent(warp)}
#endif
`
