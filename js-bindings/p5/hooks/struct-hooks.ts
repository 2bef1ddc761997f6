/** p5 2.x on WebGL: in each space, a hook takes and returns a vertex as one struct. */
import { type HookStyle, type WarpCode, glslDeclarations } from './styles.js'
import type { HookOrder } from './merge-hooks.js'
import { zeroNormalHooks } from './zero-normals.js'
import {
  readsVariation,
  variationInGlsl,
  variationDeclarations,
} from '../variation/variation-text.js'
import type { WarpSpace } from '../settings.js'

export const hookIn: Record<WarpSpace, string> = {
  local: 'getObjectInputs',
  world: 'getWorldInputs',
  camera: 'getCameraInputs',
}

/** The sketch's vertex hooks run first, unless the option `hooks` says otherwise for the warp's space; its other hooks run last. */
export const orderInStruct = (name: string, { space, hooks }: WarpCode): HookOrder =>
  name.endsWith(hookIn[space]) ? hooks : name.startsWith('Vertex') ? 'first' : 'last'

/** `exactNormals` declares this global too. */
const flat = 'bool warpjetNormalIsZero;'

/** Maps a space to the matrix that transforms normals from the shape's own space to it. */
export const normalMatrices = { local: '', world: 'uModelNormalMatrix', camera: 'uNormalMatrix' }

/**
 * p5's normal shader normalizes at the end of `main`, so we zero collapsed normals in `afterVertex`. Its lit shader interpolates
 * without normalizing first; under a scale that differs by axis, as for `plane(400, 400)`, the longest normals would dominate.
 */
export const structHooks: HookStyle = {
  isOrdered: true,
  orderOf: orderInStruct,
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
    instance: 'warpjetInstance',
  },
  fill(warpCode, _type, base) {
    const { text, space } = warpCode
    const varies = readsVariation(text)
    return {
      vertexDeclarations: glslDeclarations(
        warpCode,
        !base.hooks.vertex.declarations?.includes(flat) && flat,
        varies && variationDeclarations,
      ),
      [`Vertex ${hookIn[space]}`]: `(Vertex warpjetInputs) {
${varies ? variationInGlsl(normalMatrices[space]) : ''}${text.code}
  warpjetNormalIsZero = warpjetNormal == vec3(0.0);
  warpjetInputs.position = warpjetPosition;
  warpjetInputs.normal = warpjetNormal;
  return warpjetInputs;
}`,
      'void afterVertex':
        'Inputs getPixelInputs' in base.hooks.fragment
          ? '() { vNormal = warpjetNormalIsZero ? vec3(0.0) : normalize(vNormal); }'
          : '() { if (warpjetNormalIsZero) vVertexNormal = vec3(0.0); }',
      ...zeroNormalHooks(base),
    }
  },
  stroke: (warpCode) => ({
    vertexDeclarations: glslDeclarations(warpCode, 'vec3 warpjetTangentIn, warpjetTangentOut;'),
    ...strokeHooks(warpCode),
  }),
}

/**
 * p5 computes the directions of a line from its attributes again in each space, discarding the results of earlier hooks. Globals keep
 * them until the last hook.
 */
function strokeHooks({ text, space }: WarpCode) {
  const transformTangent = (direction: string, matrix: string) => {
    const given = matrix ? `(${matrix} * vec4(${direction}, 0.0)).xyz` : direction
    return `${given} + warpjetJacobian * ${given}`
  }
  const hook = (name: string, code: string): Record<string, string> => ({
    [`StrokeVertex ${name}`]: `(StrokeVertex warpjetInputs) {\n${code}\n  return warpjetInputs;\n}`,
  })
  const moved = `${text.code}\n  warpjetInputs.position = warpjetPosition;`
  if (space === 'camera')
    return hook(
      hookIn.camera,
      `${moved}
  warpjetInputs.tangentIn += warpjetJacobian * warpjetInputs.tangentIn;
  warpjetInputs.tangentOut += warpjetJacobian * warpjetInputs.tangentOut;`,
    )
  const [first, rest] =
    space === 'world' ? ['uModelMatrix', 'uViewMatrix'] : ['', 'uModelViewMatrix']
  return {
    ...hook(
      hookIn[space],
      `${moved}
  warpjetTangentIn = ${transformTangent('aTangentIn', first)};
  warpjetTangentOut = ${transformTangent('aTangentOut', first)};`,
    ),
    ...hook(
      hookIn.camera,
      `  warpjetInputs.tangentIn = (${rest} * vec4(warpjetTangentIn, 0.0)).xyz;
  warpjetInputs.tangentOut = (${rest} * vec4(warpjetTangentOut, 0.0)).xyz;`,
    ),
  }
}
