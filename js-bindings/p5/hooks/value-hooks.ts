/**
 * p5 1.11: separate hooks for position and normal, and those that it calls "world" are in view space. All happens in the hook
 * for the view space position, which p5 calls before the one for the normal: there every attribute and matrix is at hand, and
 * each space is a way in and a way back. Normals of world space come from p5's `uNormalMatrix`, inverse transpose of V M, as
 * Vᵀ times it; for the way back, V is rigid, so that its inverse transpose is its own rotation. GLSL 1.00 has neither
 * `transpose` (so `v * V`) nor `mat3(V)` (so `vec4(n, 0.0)`).
 */
import { given } from './beside.js'
import { facingTheEye } from './facing.js'
import {
  readsVariation,
  turnedVariation,
  variationDeclarations,
} from '../variation/variation-text.js'
import type { WarpSpace } from '../settings.js'
import { type HookStyle, glslDeclarations } from './styles.js'

export const valueHooks: HookStyle = {
  isOrdered: false,
  turnOf: (name, { space }) =>
    space !== 'camera' ? 'last' : name.endsWith('Position') ? 'first' : 'inside',
  names: {
    position: 'warpjetRestPosition',
    normal: 'warpjetSharedNormal',
    uv: 'HOOK_getUV(aTexCoord)',
    color: 'HOOK_getVertexColor(uUseVertexColor ? aVertexColor : uMaterialColor)',
    instance: 'warpjetInstance',
  },
  fill(woven, _type, base) {
    const { position, viewPosition } = positions[woven.space]
    const { normal, viewNormal, matrix } = normals[woven.space]
    const source = base.vertSrc()
    // In view space the sketch's hook comes first.
    const isTurned = woven.space === 'camera' && base.hooks.modified.vertex[worldNormal]
    const varies = readsVariation(woven.text)
    return {
      // p5 gives its normal shader medium precision, too little for a warp where a phone takes that at its word.
      vertexDeclarations: glslDeclarations(
        woven,
        'precision highp float;\nvec3 warpjetSharedNormal;',
        hooksOfTheSketch,
        isTurned && `vec3 ${given(worldNormal)}(vec3);`,
        !source.includes('uniform mat4 uModelMatrix') && matrices(woven.space),
        varies && variationDeclarations,
      ),
      'vec3 getWorldPosition': `(vec3 warpjetView) {
  vec3 warpjetRestPosition = ${position.replace('aPosition.xyz', 'HOOK_getLocalPosition(aPosition)')};
  warpjetSharedNormal = ${isTurned ? `${given(worldNormal)}(${normal})` : normal};
${varies ? turnedVariation(matrix) : ''}${woven.text.code}
  warpjetSharedNormal = ${viewNormal};
  return ${viewPosition};
}`,
      'vec3 getWorldNormal':
        '(vec3 normal) { return warpjetSharedNormal == vec3(0.0) ? warpjetSharedNormal : normalize(warpjetSharedNormal); }',
      ...facingTheEye(base),
    }
  },
  /**
   * p5 makes the directions of a line from attributes and a matrix after its last hook. So these are globals of ours from here on,
   * which begin as what they were and end as directions in view space with no matrix left to apply.
   */
  stroke(woven) {
    const { position, viewPosition, viewDirection } = positions[woven.space]
    const turned = (name: string) => `  {
    vec3 warpjetDirection = ${viewDirection.from(name)};
    warpjetDirection += warpjetSlope * warpjetDirection;
    ${name} = ${viewDirection.to('warpjetDirection')};
  }`
    return {
      vertexDeclarations: glslDeclarations(woven, kept, matrices(woven.space)),
      'void beforeVertex': `() {
  warpjetIn = warpjetGivenIn();
  warpjetOut = warpjetGivenOut();
  warpjetModelView = warpjetGivenModelView();
}`,
      'vec3 getWorldPosition': `(vec3 warpjetView) {
  vec3 warpjetRestPosition = ${position};
${woven.text.code}
${turned('warpjetIn')}
${turned('warpjetOut')}
  vec3 warpjetEnd = ${viewPosition};
  warpjetModelView = mat4(1.0);
  return warpjetEnd;
}`,
    }
  },
  point: (woven) => ({
    vertexDeclarations: glslDeclarations(woven, 'precision highp float;', matrices(woven.space)),
    'vec3 getWorldPosition': `(vec3 warpjetView) {
  vec3 warpjetRestPosition = ${positions[woven.space].position};
${woven.text.code}
  return ${positions[woven.space].viewPosition};
}`,
  }),
}

const worldNormal = 'vec3 getWorldNormal'

/** p5 calls them later. */
const hooksOfTheSketch = `vec3 HOOK_getLocalNormal(vec3);
vec2 HOOK_getUV(vec2);
vec4 HOOK_getVertexColor(vec4);`

const matrices = (space: WarpSpace) =>
  space === 'world' && 'uniform mat4 uModelMatrix;\nuniform mat4 uViewMatrix;'

const kept = `vec3 warpjetIn, warpjetOut;
mat4 warpjetModelView;
vec3 warpjetGivenIn() { return aTangentIn; }
vec3 warpjetGivenOut() { return aTangentOut; }
mat4 warpjetGivenModelView() { return uModelViewMatrix; }
#define aTangentIn warpjetIn
#define aTangentOut warpjetOut
#define uModelViewMatrix warpjetModelView`

const by = (matrix: string) => (direction: string) => `(${matrix} * vec4(${direction}, 0.0)).xyz`
const same = (direction: string) => direction

/** A line's position attribute is a vec4. */
const positions = {
  local: {
    position: 'aPosition.xyz',
    viewPosition: '(uModelViewMatrix * vec4(warpjetPosition, 1.0)).xyz',
    viewDirection: { from: same, to: by('uModelViewMatrix') },
  },
  world: {
    position: '(uModelMatrix * vec4(aPosition.xyz, 1.0)).xyz',
    viewPosition: '(uViewMatrix * vec4(warpjetPosition, 1.0)).xyz',
    viewDirection: { from: by('uModelMatrix'), to: by('uViewMatrix') },
  },
  camera: {
    position: 'warpjetView',
    viewPosition: 'warpjetPosition',
    viewDirection: { from: by('uModelViewMatrix'), to: same },
  },
}

const normals = {
  local: {
    matrix: '',
    normal: 'HOOK_getLocalNormal(aNormal)',
    viewNormal: 'uNormalMatrix * warpjetNormal',
  },
  world: {
    matrix: `mat3(${[0, 1, 2].map((i) => `(vec4(uNormalMatrix[${i}], 0.0) * uViewMatrix).xyz`).join(', ')})`,
    normal: '(vec4(uNormalMatrix * HOOK_getLocalNormal(aNormal), 0.0) * uViewMatrix).xyz',
    viewNormal: '(uViewMatrix * vec4(warpjetNormal, 0.0)).xyz',
  },
  camera: {
    matrix: 'uNormalMatrix',
    normal: 'uNormalMatrix * HOOK_getLocalNormal(aNormal)',
    viewNormal: 'warpjetNormal',
  },
}
