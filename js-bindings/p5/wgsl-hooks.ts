/**
 * p5 2.x on WebGPU: the hooks of WebGL in WGSL, where a parameter cannot be assigned and what `main` hands on is out of reach. So
 * the last hook keeps the normal in a varying of ours, and colours are worked out from that.
 */
import type { Declared } from '../module/result.js'
import type { Modifications, Shader } from './host.js'
import type { WarpSpace } from './settings.js'
import type { HookStyle, Woven } from './styles.js'

const types: Record<Declared['type'], string> = {
  float: 'f32',
  vec2: 'vec2<f32>',
  vec3: 'vec3<f32>',
  vec4: 'vec4<f32>',
  mat2: 'mat2x2<f32>',
  mat3: 'mat3x3<f32>',
  mat4: 'mat4x4<f32>',
  sampler2D: 'texture_2d<f32>',
}

const hookIn: Record<WarpSpace, string> = {
  local: 'getObjectInputs',
  world: 'getWorldInputs',
  camera: 'getCameraInputs',
}

export const wgslHooks: HookStyle = {
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
  },
  hasVariation: false,
  fill: (woven, type, base) => ({
    ...declarationsOf(woven, base, 'var<private> warpjetFlat: bool;'),
    varyingVariables: ['warpjetShown: vec3<f32>', 'warpjetSeen: vec3<f32>'],
    ...hooks('Vertex', fillHooks(woven)),
    ...(type === 'normal' ? colors : lit),
  }),
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
  if (all(warpjetShown == vec3<f32>())) { warpjetInputs.normal = normalize(-warpjetSeen); }
  else { warpjetInputs.normal = normalize(warpjetShown); }
  return warpjetInputs;
}`,
}

/** As p5's shader for normals does in WebGL; on WebGPU it has none. */
const colors = {
  'vec4<f32> getFinalColor': `(color: vec4<f32>, texCoord: vec2<f32>) {
  return vec4<f32>(warpjetShown, 1.0);
}`,
}

function fillHooks(woven: Woven): Record<string, string> {
  const warp = `${runs(woven)}
  warpjetFlat = all(warpjetTurned == vec3<f32>());
  warpjetInputs.position = warpjetMoved;
  warpjetInputs.normal = warpjetTurned;\n`
  const keep = `  warpjetSeen = warpjetInputs.position;
  warpjetShown = vec3<f32>();
  if (!warpjetFlat) { warpjetShown = normalize(warpjetInputs.normal); }`
  const name = hookIn[woven.space]
  return { [name]: warp, getCameraInputs: woven.space === 'camera' ? warp + keep : keep }
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
  uniforms
    .filter(({ type }) => type !== 'sampler2D')
    .map(({ name }) => `  let ${name} = hooks.${name};\n`)
    .join('') + text.code

function declarationsOf({ text, defs, uniforms }: Woven, base: Shader, ...own: string[]) {
  const images = uniforms.filter(({ type }) => type === 'sampler2D')
  const first = images.length
    ? base._renderer!.getNextBindingIndex!({ vert: base._vertSrc!, frag: base._fragSrc! })
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
  const moved = `${runs(woven)}\n  warpjetInputs.position = warpjetMoved;`
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
