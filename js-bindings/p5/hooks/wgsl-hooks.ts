/**
 * p5 2.x on WebGPU: the hooks of WebGL in WGSL, where a parameter cannot be assigned and what `main` hands on is out of reach. So
 * the last hook keeps the normal in a varying of ours, and colours are worked out from that.
 */
import {
  type Declared,
  type VariationInput,
  variationAttribute,
  variationNames,
} from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import { type TextOfVertex, variationIn, variationVariables } from '../variation/variation-text.js'
import type { Modifications, Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { hookIn, turnInStruct } from './struct-hooks.js'
import { type HookStyle, type Woven, readsInstance } from './styles.js'

/** Of inputs, and of the option `uniforms`. */
const types: Partial<Record<Declared['type'], string>> = {
  float: 'f32',
  vec2: 'vec2<f32>',
  vec3: 'vec3<f32>',
  vec4: 'vec4<f32>',
  mat2: 'mat2x2<f32>',
  mat3: 'mat3x3<f32>',
  mat4: 'mat4x4<f32>',
  sampler2D: 'texture_2d<f32>',
}

export const wgslHooks: HookStyle = {
  isOrdered: true,
  turnOf: turnInStruct,
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
    instance: 'warpjetInstance',
  },
  fill: (woven, type, base) => ({
    ...declarationsOf(
      woven,
      base,
      'var<private> warpjetFlat: bool;',
      ...privatesFor(attributesOf(woven)),
    ),
    varyingVariables: ['warpjetViewNormal: vec3<f32>', 'warpjetViewPosition: vec3<f32>'],
    ...hooks('Vertex', fillHooks(woven)),
    ...(type === 'normal' ? colors : 'Inputs getPixelInputs' in base.hooks.fragment && lit),
  }),
  finish: (shader, woven) =>
    addAttributes(
      shader,
      attributesOf(woven),
      'createWarp: on WEBGPU an offset that depends on both normal and uv has more attributes than a shader may; write it with one of them, or add the option { surfaceVariation: false }, which lets both count as constant.',
    ),
  stroke: (woven, base) => ({
    ...declarationsOf(
      woven,
      base,
      'var<private> warpjetIn: vec3<f32>;',
      'var<private> warpjetOut: vec3<f32>;',
    ),
    ...hooks('StrokeVertex', strokeHooks(woven)),
  }),
}

/** Where there is no normal, as if it faced the eye; see facing.ts. */
const lit = {
  'Inputs getPixelInputs': `(warpjetGiven: Inputs) {
  var warpjetInputs = warpjetGiven;
  if (all(warpjetViewNormal == vec3<f32>())) { warpjetInputs.normal = normalize(-warpjetViewPosition); }
  else { warpjetInputs.normal = normalize(warpjetViewNormal); }
  return warpjetInputs;
}`,
}

/** As p5's shader for normals does in WebGL; on WebGPU it has none. */
const colors = {
  'vec4<f32> getFinalColor': `(color: vec4<f32>, texCoord: vec2<f32>) {
  return vec4<f32>(warpjetViewNormal, 1.0);
}`,
}

function fillHooks(woven: Woven): Record<string, string> {
  const warp = `${variation(woven)}${runs(woven)}
  warpjetFlat = all(warpjetNormal == vec3<f32>());
  warpjetInputs.position = warpjetPosition;
  warpjetInputs.normal = warpjetNormal;\n`
  const keep = `  warpjetViewPosition = warpjetInputs.position;
  warpjetViewNormal = vec3<f32>();
  if (!warpjetFlat) { warpjetViewNormal = normalize(warpjetInputs.normal); }`
  const name = hookIn[woven.space]
  return { [name]: warp, getCameraInputs: woven.space === 'camera' ? warp + keep : keep }
}

/** Besides p5's four there may be four more. */
const mostBuffers = 4

const isOfNormal = (name: string) => name.startsWith('normal')

/** Globals, since attributes come in a struct, which hooks do not get. */
export const privatesFor = (names: readonly VariationInput[]) =>
  names.map((name) => `var<private> ${variationAttribute(name)}_: vec3<f32>;`)

/** Adds them to the struct, and hands them to the globals. Throws a `WarpError` with that sentence where they are too many. */
export function addAttributes(
  shader: Pick<Shader, '_vertSrc'>,
  names: readonly VariationInput[],
  tooMany: string,
) {
  if (names.length === 0) return
  if (names.length > mostBuffers) throw new WarpError(tooMany)
  const fields = names.map(
    (name, i) => `  @location(${4 + i}) ${variationAttribute(name)}: vec3<f32>,\n`,
  )
  const globals = names.map(
    (name) => `  ${variationAttribute(name)}_ = input.${variationAttribute(name)};\n`,
  )
  shader._vertSrc = shader
    ._vertSrc!.replace(/(struct VertexInput \{[^}]*)\}/, `$1${fields.join('')}}`)
    .replace('HOOK_beforeVertex();', `${globals.join('')}  HOOK_beforeVertex();`)
}

/** A text, and the space of the offset. */
interface InSpace {
  text: TextOfVertex
  space: WarpSpace
}

/** What the text reads, and beyond a shape's own space all of the normal's, if it reads any. */
export function attributesOf({ text, space }: InSpace) {
  const read = variationIn(text)
  const isWhole = space !== 'local' && read.some(isOfNormal)
  return variationNames.filter((name) => read.includes(name) || (isWhole && isOfNormal(name)))
}

/** See `turnedVariation`. `ofCamera` turns normals to view space. */
export function variation(woven: InSpace, ofCamera = 'model.uNormalMatrix'): string {
  const { space } = woven
  const names = attributesOf(woven)
  if (names.length === 0) return ''
  const given = (name: string) => `${variationAttribute(name)}_`
  const matrix = { local: '', world: 'model.uModelNormalMatrix', camera: ofCamera }[space]
  const lines = names.map((name) => {
    if (!matrix) return given(name)
    if (!isOfNormal(name)) return `warpjetN * ${given(name)}`
    const row = 'XYZ'.indexOf(name[6]!)
    const all = ['X', 'Y', 'Z'].map((axis) => `normal${axis}Gradient`)
    const sum = all
      .map((each, i) => names.includes(each as never) && `${given(each)} * warpjetN[${i}][${row}]`)
      .filter(Boolean)
    return `warpjetN * (${sum.join(' + ')})`
  })
  return (
    (matrix && `  let warpjetN = ${matrix};\n`) +
    names.map((name, i) => `  let ${variationVariables[name]} = ${lines[i]};\n`).join('')
  )
}

/** Hooks by their bodies. */
function hooks(struct: string, bodies: Record<string, string>): Modifications {
  return Object.fromEntries(
    Object.entries(bodies).map(([name, body]) => [
      `${struct} ${name}`,
      `(warpjetGiven: ${struct}) {\n  var warpjetInputs = warpjetGiven;\n${body}\n  return warpjetInputs;\n}`,
    ]),
  )
}

/** The text, with the uniforms under the names that they have in GLSL. */
const runs = ({ text, uniforms }: Woven) =>
  (readsInstance(text) ? '  let warpjetInstance = f32(instanceID);\n' : '') +
  uniforms
    .filter(({ type }) => type !== 'sampler2D')
    .map(({ name }) => `  let ${name} = hooks.${name};\n`)
    .join('') +
  text.code

function declarationsOf({ text, defs, uniforms }: Woven, base: Shader, ...own: string[]) {
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
        .map(({ name, type }) => [`${name}: ${types[type]}`, undefined]),
    ),
    // Of both stages, or p5 would number their bindings apart.
    declarations: images
      .map(
        ({ name, type }, i) => `@group(0) @binding(${first + 2 * i}) var ${name}: ${types[type]};
@group(0) @binding(${first + 2 * i + 1}) var ${name}_sampler: sampler;`,
      )
      .join('\n'),
    vertexDeclarations: [...own, defs, text.declarations].filter(Boolean).join('\n'),
  }
}

/** See struct-hooks.ts. p5 gives the hook of world space directions that are moved too, so the first hook keeps them. */
function strokeHooks(woven: Woven): Record<string, string> {
  const { space } = woven
  const moved = `${runs(woven)}\n  warpjetInputs.position = warpjetPosition;`
  if (space === 'camera')
    return {
      getCameraInputs: `${moved}
  warpjetInputs.tangentIn += warpjetSlope * warpjetInputs.tangentIn;
  warpjetInputs.tangentOut += warpjetSlope * warpjetInputs.tangentOut;`,
    }
  const keep = '  warpjetIn = warpjetInputs.tangentIn;\n  warpjetOut = warpjetInputs.tangentOut;'
  const turn = `  warpjetIn += warpjetSlope * warpjetIn;\n  warpjetOut += warpjetSlope * warpjetOut;`
  const by = (matrix: string) => (name: string) => `(model.${matrix} * vec4<f32>(${name}, 0.0)).xyz`
  const world = by('uModelMatrix')
  const view = by(space === 'world' ? 'uViewMatrix' : 'uModelViewMatrix')
  return {
    ...(space === 'local'
      ? { getObjectInputs: `${keep}\n${moved}\n${turn}` }
      : {
          getObjectInputs: keep,
          getWorldInputs: `  warpjetIn = ${world('warpjetIn')};\n  warpjetOut = ${world('warpjetOut')};\n${moved}\n${turn}`,
        }),
    getCameraInputs: `  warpjetInputs.tangentIn = ${view('warpjetIn')};
  warpjetInputs.tangentOut = ${view('warpjetOut')};`,
  }
}
