// Writes the statements that warp the vertex and its normals in a vertex shader of WebGLRenderer.
import { shaderNames } from '../compile/hosts.js'
import type { PixelNormals } from './pixel-normals.js'
import { chunkSource } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'
import type { Surface, WarpCode } from './warp-code.js'

/** Returns the statements that warp `transformed` and the normals. `isUnchanged` is true if only three.js' own lines compute the normal. */
export function warpBlock(
  code: WarpCode,
  isLit: boolean,
  isUnchanged: boolean,
  pixel: PixelNormals | undefined,
): string {
  const lit = isUnchanged ? warpAtObject(code, pixel) : warpAtView(code)
  const unlit = warpPositionOnly(code)
  const both = `#if defined( WARPJET_OBJECT_NORMAL ) && defined( WARPJET_TRANSFORMED_NORMAL ) && ! defined( WARPJET_NORMAL_DONE )
${lit}
#else
${unlit}
#endif`
  return `{
vec3 warpjetStart = transformed;
${code.preparation}${code.isWorld && pixel ? `${pixel.clear}\n` : ''}${code.guard(isLit ? both : unlit)}
}`
}

/** Three.js' variables for the normal and the tangent in the space of the object. */
export const atObject: Surface = { normal: 'objectNormal', tangent: 'objectTangent' }

/** Returns statements that warp only the position. An offset along the normal needs the normal after morph targets and bones. */
function warpPositionOnly(code: WarpCode) {
  const { code: statements, position } = code.evaluate('warpjetStart', {
    normal: code.movesByNormal ? 'warpjetObjectNormal' : 'vec3( normal )',
    tangent: 'tangent.xyz',
  })
  const isRest = code.warp.settings.space === 'rest'
  const posed = isRest
    ? ''
    : ['morphnormal_vertex', 'skinnormal_vertex'].map(chunkSource).join('\n')
  const normal = `vec3 warpjetObjectNormal;
#ifdef WARPJET_NORMAL_DONE
warpjetObjectNormal = warpjetRestObjectNormal;
#elif defined( WARPJET_OBJECT_NORMAL )
warpjetObjectNormal = objectNormal;
#else
{
${chunkSource('beginnormal_vertex')}
${posed}
warpjetObjectNormal = objectNormal;
}
#endif
`
  return `${code.movesByNormal ? normal : ''}${statements}\ntransformed = ${position};`
}

/** Returns statements that warp position and normals, if only three.js' own lines compute the normal. */
function warpAtObject(code: WarpCode, pixel: PixelNormals | undefined) {
  const { code: statements, position, ...surface } = code.evaluate('warpjetStart', atObject)
  return `${statements}
${pixel ? `${pixel.pass(code.names)}\n` : ''}transformed = ${position};
vec3 warpjetViewNormal;
${toView(code, surface, true)}
transformedNormal = warpjetViewNormal;`
}

/**
 * Returns statements that warp position and normals, if other code changes a normal: each normal is transformed back to the object by
 * itself.
 */
function warpAtView(code: WarpCode) {
  const moved = code.evaluate('warpjetStart', atObject)
  const warpBack = (normal: string, tangent: string, hasVarying: boolean) => {
    const { code: statements, ...surface } = code.evaluate('warpjetStart', {
      normal: `warpjetFlip * ( ${normal} * warpjetObjectToView )`,
      tangent: `inverse( warpjetObjectToView ) * ${tangent}`,
    })
    return `{\n${statements}\n${toView(code, surface, hasVarying)}\n}`
  }
  return `{
${moved.code}
transformed = ${moved.position};
}
mat3 warpjetObjectToView = mat3( modelViewMatrix );
#ifdef USE_BATCHING
warpjetObjectToView = warpjetObjectToView * mat3( batchingMatrix );
#endif
#if defined( USE_INSTANCING ) || defined( USE_INSTANCING_INDIRECT )
warpjetObjectToView = warpjetObjectToView * mat3( instanceMatrix );
#endif
#ifdef FLIP_SIDED
float warpjetFlip = -1.0;
#else
float warpjetFlip = 1.0;
#endif
vec3 warpjetViewNormal;
#ifdef WARPJET_VARYING_NORMAL
${warpBack('vNormal', 'vTangent', true)}
#endif
${warpBack('transformedNormal', 'transformedTangent', false)}
transformedNormal = warpjetViewNormal;`
}

/**
 * Returns statements that run three.js' own lines from the normal of the object to that of the view, with the results of an evaluation.
 * `pose` are lines that come before these.
 */
export const toView = (
  { warp }: WarpCode,
  { normal, tangent }: Surface,
  hasVarying: boolean,
  pose = '',
) => `{
vec3 objectNormal = ${normal};
#ifdef USE_TANGENT
vec3 objectTangent = ${tangent};
#endif
${pose}
${chunkSource('defaultnormal_vertex')}
${avoidNaN}
${
  hasVarying
    ? `#ifdef WARPJET_VARYING_NORMAL
${chunkSource('normal_vertex')}
vNormal *= mix( 1.0, 1e-6, warpjetFlat );
${orientBitangent(warp)}
#endif`
    : ''
}
warpjetViewNormal = transformedNormal;
}`

/**
 * A warp that collapses the surface makes its normal zero, and three.js would normalize that to NaN. Such a vertex is lit as if it faced
 * the eye, with so little weight that its neighbors decide wherever they have a normal. Branches that differ from vertex to
 * vertex would make the whole frame 3% slower on SwiftShader.
 */
const avoidNaN = `float warpjetFlat = float( transformedNormal == vec3( 0.0 ) );
transformedNormal.z += warpjetFlat;
#ifdef USE_TANGENT
transformedTangent.x += float( transformedTangent == vec3( 0.0 ) );
#endif`

/** Returns statements that correct the side of the bitangent, which three.js takes from the attribute, for a warp that mirrors. */
export const orientBitangent = ({ mirrors }: ThreeWarp) =>
  mirrors === false
    ? ''
    : `#ifdef USE_TANGENT
vBitangent *= ${shaderNames.orientation};
#endif`
