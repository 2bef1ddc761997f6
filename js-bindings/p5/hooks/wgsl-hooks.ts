/**
 * On WebGPU, p5 2.x has the same hooks as on WebGL, written in WGSL. WGSL parameters are immutable, and a hook cannot change the varyings
 * that `main` writes. So the last hook stores the normal in a varying that we declare, and the fragment hooks read it.
 */
import type { Declared, HostText } from '../../compile/hosts.js'
import type { Modifications, Shader } from '../host.js'
import { variationVariables } from '../variation/variation-text.js'
import {
  addAttributes,
  attributesOf,
  declarePrivates,
  variationInWgsl,
} from '../variation/variation-wgsl.js'
import { facingInWgsl } from './facing.js'
import { passInputs } from './pixel-code.js'
import { pixelVaryings, readInputs, toView, wgslTypes } from './pixel-normals-wgsl.js'
import { hookIn, isAfterWarpInStruct, orderInStruct } from './struct-hooks.js'
import { readsInstance, type HookStyle, type MaterialKind, type WarpCode } from './styles.js'

export const wgslHooks: HookStyle = {
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
  hooksForFills(code, type, base) {
    const readsNormals = type === 'normal' || isLit(base)
    const warpCode = readsNormals ? code : { ...code, pixel: undefined }
    const { pixel } = warpCode
    return {
      ...declarationsOf(
        warpCode,
        base,
        'var<private> warpjetNormalIsZero: bool;',
        ...declarePrivates(attributesOf(warpCode)),
      ),
      fragmentDeclarations: [
        ...(pixel ? [warpCode.defs, pixel.text.declarations] : []),
        facingInWgsl,
      ]
        .filter(Boolean)
        .join('\n'),
      ...(readsNormals && {
        varyingVariables: [
          'warpjetViewNormal: vec3<f32>',
          'warpjetViewPosition: vec3<f32>',
          ...pixelVaryings(pixel),
        ],
      }),
      ...hooks(
        'Vertex',
        fillVertexHooks(warpCode, { ...this.names, ...variationVariables }, readsNormals),
      ),
      ...fragmentHooks(warpCode, type, base),
    }
  },
  finish: (shader, warpCode) =>
    addAttributes(
      shader,
      attributesOf(warpCode),
      'createWarp: on WEBGPU an offset that depends on both normal and uv needs more attributes than a shader may have; read only one of them, or add the option { surfaceVariation: false }, which treats both as constant.',
    ),
  hooksForStrokes: (warpCode, base) => ({
    ...declarationsOf(
      warpCode,
      base,
      'var<private> warpjetTangentIn: vec3<f32>;',
      'var<private> warpjetTangentOut: vec3<f32>;',
    ),
    ...hooks('StrokeVertex', strokeHooks(warpCode)),
  }),
}

const isLit = ({ hooks }: Shader) => 'Inputs getPixelInputs' in hooks.fragment

/**
 * Returns the hook that passes the normal to p5's lighting or, for normalMaterial(), draws it as a colour, since p5 has no normal shader
 * on WebGPU. A collapsed surface, whose normal is zero, gets its geometric normal.
 */
function fragmentHooks(warpCode: WarpCode, type: MaterialKind, base: Shader): Modifications {
  const { pixel, space } = warpCode
  if (type !== 'normal' && !isLit(base)) return {}
  const statements = pixel
    ? `${readInputs(pixel)}${statementsOf(pixel.text, pixel.uniforms)}
  let warpjetShownNormal = ${toView('warpjetNormal', space, base)};`
    : '  let warpjetShownNormal = warpjetViewNormal;'
  const body = `  let warpjetFacingNormal = warpjetFacing(warpjetViewPosition);
${statements}
  let warpjetUnitNormal = select(normalize(warpjetShownNormal), warpjetFacingNormal, all(warpjetShownNormal == vec3<f32>()));`
  if (type !== 'normal')
    return {
      'Inputs getPixelInputs': `(warpjetOriginalInputs: Inputs) {
  var warpjetInputs = warpjetOriginalInputs;
${body}
  warpjetInputs.normal = warpjetUnitNormal;
  return warpjetInputs;
}`,
    }
  return {
    'vec4<f32> getFinalColor': `(color: vec4<f32>, texCoord: vec2<f32>) {
${body}
  return vec4<f32>(warpjetUnitNormal, 1.0);
}`,
  }
}

function fillVertexHooks(
  warpCode: WarpCode,
  names: Readonly<Record<string, string>>,
  readsNormals: boolean,
): Record<string, string> {
  const warp = `${variationInWgsl(warpCode)}${warpStatements(warpCode, passInputs(warpCode.pixel, names, wgslTypes.vec4!))}
  warpjetNormalIsZero = all(warpjetNormal == vec3<f32>());
  warpjetInputs.position = warpjetPosition;
  warpjetInputs.normal = warpjetNormal;\n`
  const storeNormal = `  warpjetViewPosition = warpjetInputs.position;
  warpjetViewNormal = vec3<f32>();
  if (!warpjetNormalIsZero) { warpjetViewNormal = normalize(warpjetInputs.normal); }`
  const name = hookIn[warpCode.space]
  if (!readsNormals) return { [name]: warp }
  return {
    [name]: warp,
    getCameraInputs: warpCode.space === 'camera' ? warp + storeNormal : storeNormal,
  }
}

/** Wraps each body in a function that takes a `struct` and returns it. */
function hooks(struct: string, bodies: Record<string, string>): Modifications {
  return Object.fromEntries(
    Object.entries(bodies).map(([name, body]) => [
      `${struct} ${name}`,
      `(warpjetOriginalInputs: ${struct}) {\n  var warpjetInputs = warpjetOriginalInputs;\n${body}\n  return warpjetInputs;\n}`,
    ]),
  )
}

/**
 * Returns the warp's code, preceded by statements that declare the instance if the code reads it, by `pass`, and by a local variable per
 * uniform, named as in GLSL.
 */
const warpStatements = ({ text, uniforms }: WarpCode, pass = '') =>
  (readsInstance(text) ? '  let warpjetInstance = f32(instanceID);\n' : '') +
  pass +
  statementsOf(text, uniforms)

const statementsOf = (text: HostText, uniforms: readonly Declared[]) =>
  uniforms
    .filter(({ type }) => type !== 'sampler2D')
    .map(({ name }) => `  let ${name} = hooks.${name};\n`)
    .join('') + text.code

function declarationsOf({ text, defs, uniforms }: WarpCode, base: Shader, ...own: string[]) {
  const images = uniforms.filter(({ type }) => type === 'sampler2D')
  const first = images.length
    ? base._renderer!.getNextBindingIndex!({
        vert: `${base._vertSrc!}${base.hooks.declarations ?? ''}`,
        frag: base._fragSrc!,
      })
    : 0
  return {
    uniforms: Object.fromEntries(
      uniforms
        .filter(({ type }) => type !== 'sampler2D')
        .map(({ name, type }) => [`${name}: ${wgslTypes[type]}`, undefined]),
    ),
    // Declared in both stages, or p5 would number their bindings differently.
    declarations: images
      .map(
        (
          { name, type },
          i,
        ) => `@group(0) @binding(${first + 2 * i}) var ${name}: ${wgslTypes[type]};
@group(0) @binding(${first + 2 * i + 1}) var ${name}_sampler: sampler;`,
      )
      .join('\n'),
    vertexDeclarations: [...own, defs, text.declarations].filter(Boolean).join('\n'),
  }
}

/** See struct-hooks.ts. In world space, p5 also translates the tangents, which are directions, so the first hook stores the originals. */
function strokeHooks(warpCode: WarpCode): Record<string, string> {
  const { space } = warpCode
  const moved = `${warpStatements(warpCode)}\n  warpjetInputs.position = warpjetPosition;`
  if (space === 'camera')
    return {
      getCameraInputs: `${moved}
  warpjetInputs.tangentIn += warpjetJacobian * warpjetInputs.tangentIn;
  warpjetInputs.tangentOut += warpjetJacobian * warpjetInputs.tangentOut;`,
    }
  const storeTangents =
    '  warpjetTangentIn = warpjetInputs.tangentIn;\n  warpjetTangentOut = warpjetInputs.tangentOut;'
  const warpTangents = `  warpjetTangentIn += warpjetJacobian * warpjetTangentIn;\n  warpjetTangentOut += warpjetJacobian * warpjetTangentOut;`
  const transformBy = (matrix: string) => (name: string) =>
    `(model.${matrix} * vec4<f32>(${name}, 0.0)).xyz`
  const world = transformBy('uModelMatrix')
  const view = transformBy(space === 'world' ? 'uViewMatrix' : 'uModelViewMatrix')
  return {
    ...(space === 'local'
      ? { getObjectInputs: `${storeTangents}\n${moved}\n${warpTangents}` }
      : {
          getObjectInputs: storeTangents,
          getWorldInputs: `  warpjetTangentIn = ${world('warpjetTangentIn')};\n  warpjetTangentOut = ${world('warpjetTangentOut')};\n${moved}\n${warpTangents}`,
        }),
    getCameraInputs: `  warpjetInputs.tangentIn = ${view('warpjetTangentIn')};
  warpjetInputs.tangentOut = ${view('warpjetTangentOut')};`,
  }
}
