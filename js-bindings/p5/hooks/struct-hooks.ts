/** p5 2.x on WebGL: in each space, a hook takes and returns a vertex as one struct. */
import type { WarpSpace } from '../settings.js'
import {
  readsVariation,
  variationDeclarations,
  variationInGlsl,
  variationVariables,
} from '../variation/variation-text.js'
import type { HookOrder } from './merge-hooks.js'
import { passInputs } from './pixel-code.js'
import {
  passViewPosition,
  pixelDeclarations,
  pixelHooks,
  readsNormals,
  type ToView,
} from './pixel-normals.js'
import { glslDeclarations, type HookStyle, type WarpCode } from './styles.js'
import { zeroNormalHooks } from './zero-normals.js'

export const hookIn: Record<WarpSpace, string> = {
  local: 'getObjectInputs',
  world: 'getWorldInputs',
  camera: 'getCameraInputs',
}

/** The sketch's vertex hooks run first, unless the option `hooks` says otherwise for the warp's space; its other hooks run last. */
export const orderInStruct = (name: string, { space, hooks }: WarpCode): HookOrder =>
  name.endsWith(hookIn[space]) ? hooks : name.startsWith('Vertex') ? 'first' : 'last'

const vertexHooks = [...Object.values(hookIn).map((name) => `Vertex ${name}`), 'void afterVertex']

export function isAfterWarpInStruct(
  name: string,
  { space, hooks }: Pick<WarpCode, 'space' | 'hooks'>,
) {
  const [hook, ours] = [name, `Vertex ${hookIn[space]}`].map((each) => vertexHooks.indexOf(each))
  return hook === ours ? hooks === 'last' : hook! > ours!
}

/** Declares a global that `exactNormals` may have declared already. */
const zeroNormalDeclaration = 'bool warpjetNormalIsZero;'

/** Maps a space to the matrix that transforms normals from the shape's own space into that space. */
export const normalMatrices = { local: '', world: 'uModelNormalMatrix', camera: 'uNormalMatrix' }

const matrixToView = (name: string): ToView => ({
  matrix: ['mat3', name],
  transform: (normal) => `${name} * ${normal}`,
})

/** p5 sets each of these matrices in both stages, whether its own source declares it or not. */
const matricesToView: Record<WarpSpace, ToView> = {
  local: matrixToView('uNormalMatrix'),
  world: matrixToView('uCameraNormalMatrix'),
  camera: { transform: (normal) => normal },
}

/**
 * p5's normal shader normalizes at the end of `main`, so we zero collapsed normals in `afterVertex`. Its lit shader interpolates
 * without normalizing first; under a scale that differs by axis, as for `plane(400, 400)`, the longest normals would dominate.
 */
export const structHooks: HookStyle = {
  canRunLast: true,
  orderOf: orderInStruct,
  isAfterWarp: isAfterWarpInStruct,
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
    instance: 'warpjetInstance',
  },
  fill(warpCode, _type, base) {
    const { text, space, target } = warpCode
    const pixel = readsNormals(base) ? warpCode.pixel : undefined
    const varies = readsVariation(text)
    const names = { ...this.names, ...variationVariables }
    const position = passViewPosition(pixel, base, 'warpjetInputs.position')
    return {
      vertexDeclarations: glslDeclarations(
        warpCode,
        !base.hooks.vertex.declarations?.includes(zeroNormalDeclaration) && zeroNormalDeclaration,
        varies && variationDeclarations,
        pixelDeclarations(pixel, base),
      ),
      ...(position && space !== 'camera' && vertexHook('camera', position)),
      ...vertexHook(
        space,
        `${varies ? variationInGlsl(normalMatrices[space]) : ''}${passInputs(pixel, names, 'vec4')}${text.code}
  warpjetNormalIsZero = warpjetNormal == vec3(0.0);
  warpjetInputs.position = warpjetPosition;
  warpjetInputs.normal = warpjetNormal;
${space === 'camera' ? position : ''}`,
      ),
      'void afterVertex':
        'Inputs getPixelInputs' in base.hooks.fragment
          ? '() { vNormal = warpjetNormalIsZero ? vec3(0.0) : normalize(vNormal); }'
          : '() { if (warpjetNormalIsZero) vVertexNormal = vec3(0.0); }',
      ...(pixel
        ? pixelHooks(warpCode, pixel, base, matricesToView[space])
        : zeroNormalHooks(base, target)),
    }
  },
  stroke: (warpCode) => ({
    vertexDeclarations: glslDeclarations(warpCode, 'vec3 warpjetTangentIn, warpjetTangentOut;'),
    ...strokeHooks(warpCode),
  }),
}

const vertexHook = (space: WarpSpace, statements: string) => ({
  [`Vertex ${hookIn[space]}`]: `(Vertex warpjetInputs) {\n${statements}  return warpjetInputs;\n}`,
})

/**
 * p5 computes the directions of a line from its attributes again in each space, discarding the results of earlier hooks. So globals keep
 * the warped directions until the last hook.
 */
function strokeHooks({ text, space }: WarpCode) {
  const transformTangent = (direction: string, matrix: string) => {
    const tangent = matrix ? `(${matrix} * vec4(${direction}, 0.0)).xyz` : direction
    return `${tangent} + warpjetJacobian * ${tangent}`
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
  const [toOffsetSpace, toViewSpace] =
    space === 'world' ? ['uModelMatrix', 'uViewMatrix'] : ['', 'uModelViewMatrix']
  return {
    ...hook(
      hookIn[space],
      `${moved}
  warpjetTangentIn = ${transformTangent('aTangentIn', toOffsetSpace)};
  warpjetTangentOut = ${transformTangent('aTangentOut', toOffsetSpace)};`,
    ),
    ...hook(
      hookIn.camera,
      `  warpjetInputs.tangentIn = (${toViewSpace} * vec4(warpjetTangentIn, 0.0)).xyz;
  warpjetInputs.tangentOut = (${toViewSpace} * vec4(warpjetTangentOut, 0.0)).xyz;`,
    ),
  }
}
