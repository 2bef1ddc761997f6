/** p5 2.x in WebGL: a vertex comes as one struct through a hook in each space. */
import { type HookStyle, type Woven, glslDeclarations } from './styles.js'
import type { Turn } from './beside.js'
import { facingTheEye } from './facing.js'
import {
  readsVariation,
  turnedVariation,
  variationDeclarations,
} from '../variation/variation-text.js'
import type { WarpSpace } from '../settings.js'

export const hookIn: Record<WarpSpace, string> = {
  local: 'getObjectInputs',
  world: 'getWorldInputs',
  camera: 'getCameraInputs',
}

/** The sketch's hooks of vertices are the first, or as it wishes in the space of the warp; others go on from what ours made. */
export const turnInStruct = (name: string, { space, hooks }: Woven): Turn =>
  name.endsWith(hookIn[space]) ? hooks : name.startsWith('Vertex') ? 'first' : 'last'

/** `exactNormals` declares it too. */
const flat = 'bool warpjetFlat;'

/** What turns normals from the shape's own space to another. */
export const normalMatrices = { local: '', world: 'uModelNormalMatrix', camera: 'uNormalMatrix' }

/**
 * p5's normal shader normalizes at the end of main, hence the last word in `afterVertex`. Its lit shader does not
 * before it interpolates, and where a scale differs by axis, as for `plane(400, 400)`, the longest normals would rule.
 */
export const structHooks: HookStyle = {
  isOrdered: true,
  turnOf: turnInStruct,
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
    instance: 'warpjetInstance',
  },
  fill(woven, _type, base) {
    const { text, space } = woven
    const varies = readsVariation(text)
    return {
      vertexDeclarations: glslDeclarations(
        woven,
        !base.hooks.vertex.declarations?.includes(flat) && flat,
        varies && variationDeclarations,
      ),
      [`Vertex ${hookIn[space]}`]: `(Vertex warpjetInputs) {
${varies ? turnedVariation(normalMatrices[space]) : ''}${text.code}
  warpjetFlat = warpjetNormal == vec3(0.0);
  warpjetInputs.position = warpjetPosition;
  warpjetInputs.normal = warpjetNormal;
  return warpjetInputs;
}`,
      'void afterVertex':
        'Inputs getPixelInputs' in base.hooks.fragment
          ? '() { vNormal = warpjetFlat ? vec3(0.0) : normalize(vNormal); }'
          : '() { if (warpjetFlat) vVertexNormal = vec3(0.0); }',
      ...facingTheEye(base),
    }
  },
  stroke: (woven) => ({
    vertexDeclarations: glslDeclarations(woven, 'vec3 warpjetIn, warpjetOut;'),
    ...strokeHooks(woven),
  }),
}

/**
 * p5 works the directions of a line out from its attributes again in each space, and forgets what a hook made of them: so they
 * wait in globals until the last hook.
 */
function strokeHooks({ text, space }: Woven) {
  const turned = (direction: string, matrix: string) => {
    const given = matrix ? `(${matrix} * vec4(${direction}, 0.0)).xyz` : direction
    return `${given} + warpjetSlope * ${given}`
  }
  const hook = (name: string, code: string): Record<string, string> => ({
    [`StrokeVertex ${name}`]: `(StrokeVertex warpjetInputs) {\n${code}\n  return warpjetInputs;\n}`,
  })
  const moved = `${text.code}\n  warpjetInputs.position = warpjetPosition;`
  if (space === 'camera')
    return hook(
      hookIn.camera,
      `${moved}
  warpjetInputs.tangentIn += warpjetSlope * warpjetInputs.tangentIn;
  warpjetInputs.tangentOut += warpjetSlope * warpjetInputs.tangentOut;`,
    )
  const [first, rest] =
    space === 'world' ? ['uModelMatrix', 'uViewMatrix'] : ['', 'uModelViewMatrix']
  return {
    ...hook(
      hookIn[space],
      `${moved}
  warpjetIn = ${turned('aTangentIn', first)};
  warpjetOut = ${turned('aTangentOut', first)};`,
    ),
    ...hook(
      hookIn.camera,
      `  warpjetInputs.tangentIn = (${rest} * vec4(warpjetIn, 0.0)).xyz;
  warpjetInputs.tangentOut = (${rest} * vec4(warpjetOut, 0.0)).xyz;`,
    ),
  }
}
