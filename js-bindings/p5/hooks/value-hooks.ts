/**
 * p5 1.11 has separate hooks for position and normal, and those that it calls "world" are in view space. We do everything in the hook
 * for the view-space position, which p5 calls before the one for the normal: every attribute and matrix is available there, and each
 * space needs a transform into it and one back. With the view matrix V and the model matrix M, world-space normals are transformed by Vᵀ
 * times p5's `uNormalMatrix`, which is the inverse transpose of V M; to return to view space, they are multiplied by V's rotation, because
 * V is rigid. GLSL 1.00 has neither `transpose` (hence `v * V`) nor `mat3(V)` (hence `vec4(n, 0.0)`).
 */
import type { WarpSpace } from '../settings.js'
import {
  readsVariation,
  variationDeclarations,
  variationInGlsl,
  variationVariables,
} from '../variation/variation-text.js'
import { sketchHook } from './merge-hooks.js'
import { passInputs } from './pixel-code.js'
import {
  passViewPosition,
  pixelDeclarations,
  pixelHooks,
  readsNormals,
  type ToView,
} from './pixel-normals.js'
import { glslDeclarations, type HookStyle } from './styles.js'
import { zeroNormalHooks } from './zero-normals.js'

export const valueHooks: HookStyle = {
  canRunLast: false,
  orderOf: (name, { space }) =>
    space !== 'camera' ? 'last' : name.endsWith('Position') ? 'first' : 'inside',
  isAfterWarp: (name, { space }) =>
    name === 'void afterVertex' || (space !== 'camera' && name === worldNormal),
  names: {
    position: 'warpjetRestPosition',
    normal: 'warpjetSharedNormal',
    uv: 'HOOK_getUV(aTexCoord)',
    color: 'HOOK_getVertexColor(uUseVertexColor ? aVertexColor : uMaterialColor)',
    instance: 'warpjetInstance',
  },
  fill(warpCode, _type, base) {
    const { position, viewPosition } = positions[warpCode.space]
    const { normal, matrix, toView } = normals[warpCode.space]
    const { transform } = toView
    const source = base.vertSrc()
    // In view space the sketch's hook runs first.
    const hasNormalHook = warpCode.space === 'camera' && base.hooks.modified.vertex[worldNormal]
    const varies = readsVariation(warpCode.text)
    const pixel = readsNormals(base) ? warpCode.pixel : undefined
    const names = { ...this.names, ...variationVariables }
    return {
      // p5's normal shader has medium precision, too little for a warp on phones that really use 16 bits.
      vertexDeclarations: glslDeclarations(
        warpCode,
        'precision highp float;\nvec3 warpjetSharedNormal;',
        forwardDeclarations,
        hasNormalHook && `vec3 ${sketchHook(worldNormal)}(vec3);`,
        !source.includes('uniform mat4 uModelMatrix') && matrices(warpCode.space),
        varies && variationDeclarations,
        pixelDeclarations(pixel, base),
      ),
      'vec3 getWorldPosition': `(vec3 warpjetViewPosition) {
  vec3 warpjetRestPosition = ${position.replace('aPosition.xyz', 'HOOK_getLocalPosition(aPosition)')};
  warpjetSharedNormal = ${hasNormalHook ? `${sketchHook(worldNormal)}(${normal})` : normal};
${varies ? variationInGlsl(matrix) : ''}${passInputs(pixel, names, 'vec4')}${warpCode.text.code}
  warpjetSharedNormal = ${transform('warpjetNormal')};
  warpjetViewPosition = ${viewPosition};
${passViewPosition(pixel, base, 'warpjetViewPosition')}  return warpjetViewPosition;
}`,
      'vec3 getWorldNormal':
        '(vec3 normal) { return warpjetSharedNormal == vec3(0.0) ? warpjetSharedNormal : normalize(warpjetSharedNormal); }',
      ...(pixel
        ? pixelHooks(warpCode, pixel, base, toView)
        : zeroNormalHooks(base, warpCode.target)),
    }
  },
  /**
   * p5 computes the directions of a line from attributes and a matrix after its last hook. We redefine these names as globals: they
   * start with the original values, and end as directions in view space with an identity matrix.
   */
  stroke(warpCode) {
    const { position, viewPosition, direction } = positions[warpCode.space]
    const transformTangent = (name: string) => `  {
    vec3 warpjetDirection = ${direction.toOffsetSpace(name)};
    warpjetDirection += warpjetJacobian * warpjetDirection;
    ${name} = ${direction.toView('warpjetDirection')};
  }`
    return {
      vertexDeclarations: glslDeclarations(warpCode, lineGlobals, matrices(warpCode.space)),
      'void beforeVertex': `() {
  warpjetTangentIn = warpjetAttributeTangentIn();
  warpjetTangentOut = warpjetAttributeTangentOut();
  warpjetModelViewMatrix = warpjetUniformModelViewMatrix();
}`,
      'vec3 getWorldPosition': `(vec3 warpjetViewPosition) {
  vec3 warpjetRestPosition = ${position};
${warpCode.text.code}
${transformTangent('warpjetTangentIn')}
${transformTangent('warpjetTangentOut')}
  vec3 warpjetLineEnd = ${viewPosition};
  warpjetModelViewMatrix = mat4(1.0);
  return warpjetLineEnd;
}`,
    }
  },
  point: (warpCode) => ({
    vertexDeclarations: glslDeclarations(
      warpCode,
      'precision highp float;',
      matrices(warpCode.space),
    ),
    'vec3 getWorldPosition': `(vec3 warpjetViewPosition) {
  vec3 warpjetRestPosition = ${positions[warpCode.space].position};
${warpCode.text.code}
  return ${positions[warpCode.space].viewPosition};
}`,
  }),
}

const worldNormal = 'vec3 getWorldNormal'

/** p5 defines these hooks below ours. */
const forwardDeclarations = `vec3 HOOK_getLocalNormal(vec3);
vec2 HOOK_getUV(vec2);
vec4 HOOK_getVertexColor(vec4);`

const matrices = (space: WarpSpace) =>
  space === 'world' && 'uniform mat4 uModelMatrix;\nuniform mat4 uViewMatrix;'

const lineGlobals = `vec3 warpjetTangentIn, warpjetTangentOut;
mat4 warpjetModelViewMatrix;
vec3 warpjetAttributeTangentIn() { return aTangentIn; }
vec3 warpjetAttributeTangentOut() { return aTangentOut; }
mat4 warpjetUniformModelViewMatrix() { return uModelViewMatrix; }
#define aTangentIn warpjetTangentIn
#define aTangentOut warpjetTangentOut
#define uModelViewMatrix warpjetModelViewMatrix`

const transformBy = (matrix: string) => (direction: string) =>
  `(${matrix} * vec4(${direction}, 0.0)).xyz`
const keepDirection = (direction: string) => direction

/** Expressions for positions in each space of the offset; `.xyz` because a line's position attribute is a vec4. */
const positions = {
  local: {
    position: 'aPosition.xyz',
    viewPosition: '(uModelViewMatrix * vec4(warpjetPosition, 1.0)).xyz',
    direction: { toOffsetSpace: keepDirection, toView: transformBy('uModelViewMatrix') },
  },
  world: {
    position: '(uModelMatrix * vec4(aPosition.xyz, 1.0)).xyz',
    viewPosition: '(uViewMatrix * vec4(warpjetPosition, 1.0)).xyz',
    direction: { toOffsetSpace: transformBy('uModelMatrix'), toView: transformBy('uViewMatrix') },
  },
  camera: {
    position: 'warpjetViewPosition',
    viewPosition: 'warpjetPosition',
    direction: { toOffsetSpace: transformBy('uModelViewMatrix'), toView: keepDirection },
  },
}

const normals: Record<WarpSpace, { matrix: string; normal: string; toView: ToView }> = {
  local: {
    matrix: '',
    normal: 'HOOK_getLocalNormal(aNormal)',
    toView: {
      matrix: ['mat3', 'uNormalMatrix'],
      transform: (normal: string) => `uNormalMatrix * ${normal}`,
      isAbovePrecision: true,
    },
  },
  world: {
    matrix: `mat3(${[0, 1, 2].map((i) => `(vec4(uNormalMatrix[${i}], 0.0) * uViewMatrix).xyz`).join(', ')})`,
    normal: '(vec4(uNormalMatrix * HOOK_getLocalNormal(aNormal), 0.0) * uViewMatrix).xyz',
    toView: { matrix: ['mat4', 'uViewMatrix'], transform: transformBy('uViewMatrix') },
  },
  camera: {
    matrix: 'uNormalMatrix',
    normal: 'uNormalMatrix * HOOK_getLocalNormal(aNormal)',
    toView: { transform: keepDirection },
  },
}
