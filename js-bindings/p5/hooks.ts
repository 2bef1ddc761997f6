/**
 * Splices a compiled warp into p5's shaders. p5 2.x hands a vertex as one struct through a hook in each space; 1.11 has
 * separate hooks for position and normal, and those that it calls "world" are in view space. What both need is said
 * once, in `weave`; the two kinds of hooks differ in the names a warp reads and in how its results get back.
 */
import type { WarpText } from '../compile/warp-text.js'
import type { Shader } from './host.js'
import type { WarpSettings, WarpSpace, WarpType } from './settings.js'
import { inputUniforms, uniformDeclarations } from './sketch-uniforms.js'
import {
  forgetLastShape,
  readsVariation,
  variationDeclarations,
  variationIn,
  variationVariables,
} from './add-surface-variation.js'

/** All of our names in p5's shaders start with warpjet, so that they meet none of the sketch's. */
export const results = {
  offset: 'warpjetOffset',
  position: 'warpjetMoved',
  normal: 'warpjetTurned',
}

type Names = Record<'position' | 'normal' | 'uv' | 'color', string>
type Hooks = Record<string, string>

interface HookStyle {
  names: Names
  /** Whether shapes can tell how they vary. */
  hasVariation: boolean
  /** GLSL above the hooks that this style needs in `space`. */
  declarations: (space: WarpSpace) => string
  /** The hooks that run `code` and hand `warpjetMoved` and `warpjetTurned` to p5. */
  hooks: (code: string, space: WarpSpace, type: WarpType) => Hooks
}

/**
 * p5 2.x. Its normal shader normalizes at the end of main, hence the last word in `afterVertex`. Its lit shader does not
 * before it interpolates, and where a scale differs by axis, as for `plane(400, 400)`, the longest normals would rule.
 */
const structHooks: HookStyle = {
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
  },
  hasVariation: true,
  declarations: () => 'bool warpjetFlat;',
  hooks: (code, space, type) => ({
    [structHookOf[space]]: `(Vertex warpjetInputs) {
${code}
  warpjetFlat = warpjetTurned == vec3(0.0);
  warpjetInputs.position = warpjetMoved;
  warpjetInputs.normal = warpjetTurned;
  return warpjetInputs;
}`,
    'void afterVertex':
      type === 'normal'
        ? '() { if (warpjetFlat) vVertexNormal = vec3(0.0); }'
        : '() { vNormal = warpjetFlat ? vec3(0.0) : normalize(vNormal); }',
  }),
}

const structHookOf: Record<WarpSpace, string> = {
  local: 'Vertex getObjectInputs',
  world: 'Vertex getWorldInputs',
  camera: 'Vertex getCameraInputs',
}

/**
 * p5 1.11. All happens in the hook for the view space position, which p5 calls before the one for the normal: there
 * every attribute and matrix is at hand, and each space is a way in and a way back. Normals of world space come from
 * p5's `uNormalMatrix`, inverse transpose of V M, as Vᵀ times it; for the way back, V is rigid, so that its inverse
 * transpose is its own rotation. GLSL 1.00 has neither `transpose` (so `v * V`) nor `mat3(V)` (so `vec4(n, 0.0)`).
 */
const valueHooks: HookStyle = {
  names: {
    position: 'warpjetPosition',
    normal: 'warpjetNormal',
    uv: 'aTexCoord',
    color: '(uUseVertexColor ? aVertexColor : uMaterialColor)',
  },
  hasVariation: false,
  // p5 gives its normal shader medium precision, too little for a warp where a phone takes that at its word.
  declarations: (space) => `precision highp float;
vec3 warpjetNormal;${space === 'world' ? '\nuniform mat4 uModelMatrix;\nuniform mat4 uViewMatrix;' : ''}`,
  hooks: (code, space) => {
    const { position, normal, viewPosition, viewNormal } = valueSpaces[space]
    return {
      'vec3 getWorldPosition': `(vec3 warpjetView) {
  vec3 warpjetPosition = ${position};
  warpjetNormal = ${normal};
${code}
  warpjetNormal = ${viewNormal};
  return ${viewPosition};
}`,
      'vec3 getWorldNormal':
        '(vec3 normal) { return warpjetNormal == vec3(0.0) ? warpjetNormal : normalize(warpjetNormal); }',
    }
  },
}

const valueSpaces = {
  local: {
    position: 'aPosition',
    normal: 'aNormal',
    viewPosition: '(uModelViewMatrix * vec4(warpjetMoved, 1.0)).xyz',
    viewNormal: 'uNormalMatrix * warpjetTurned',
  },
  world: {
    position: '(uModelMatrix * vec4(aPosition, 1.0)).xyz',
    normal: '(vec4(uNormalMatrix * aNormal, 0.0) * uViewMatrix).xyz',
    viewPosition: '(uViewMatrix * vec4(warpjetMoved, 1.0)).xyz',
    viewNormal: '(uViewMatrix * vec4(warpjetTurned, 0.0)).xyz',
  },
  camera: {
    position: 'warpjetView',
    normal: 'uNormalMatrix * aNormal',
    viewPosition: 'warpjetMoved',
    viewNormal: 'warpjetTurned',
  },
}

/**
 * Where a warp collapses a whole triangle's normals, as `floor` does, there is nothing to interpolate, and p5 would
 * light the triangle by normalize(vec3(0)). Such a place is lit as if it faced the eye.
 */
const facingTheEye = {
  'Inputs getPixelInputs': `(Inputs inputs) {
  if (vNormal == vec3(0.0)) inputs.normal = normalize(-vViewPosition);
  return inputs;
}`,
}

/** The style of p5's hooks in `base`; undefined where p5 has no hooks, before 1.11. */
export function hookStyleOf(base: Shader): HookStyle | undefined {
  const hooks = base.hooks?.vertex ?? {}
  if (structHookOf.local in hooks) return structHooks
  return 'vec3 getWorldPosition' in hooks ? valueHooks : undefined
}

/** The expressions that `compileWarp` is to use for its inputs. */
export const namesFor = ({ names }: HookStyle) => ({
  ...names,
  ...variationVariables,
  ...inputUniforms,
})

/** p5's shader `base` with the warp in it. */
export function weave(
  base: Shader,
  style: HookStyle,
  warp: WarpText,
  { space, defs }: WarpSettings,
  type: WarpType,
): Shader {
  const varies = readsVariation(warp)
  const declarations = [
    style.declarations(space),
    varies && variationDeclarations,
    uniformDeclarations(warp.uniforms),
    defs,
    warp.declarations,
  ]
  const shader = base.modify({
    vertexDeclarations: declarations.filter(Boolean).join('\n'),
    ...style.hooks((varies ? variationIn(space) : '') + warp.code, space, type),
    ...(type === 'specular' && facingTheEye),
  })
  if (varies) forgetLastShape(shader)
  // p5 1.11 draws with a shader of its own in place of one that looks unlit under lights or untextured under texture().
  return Object.assign(shader, { isLightShader: () => true, isTextureShader: () => true })
}
