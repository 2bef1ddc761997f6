/**
 * The normal in the fragment stage of a material: computed by the warp at pixels, or interpolated between vertices. Where the normal is
 * zero, as on a collapsed surface, the normal of the triangle takes its place.
 */
import { restoreLength, shaderNames } from '../compile/hosts.js'
import { ifDefined, languageOf, type Language } from './language.js'
import { names, normalDefines } from './names.js'
import {
  choose,
  sharedDeclarations,
  sideOf,
  worldColumns,
  type PixelText,
  type PixelTexts,
  type Varying,
} from './pixel-normals.js'
import { declareImages, localUniforms, type ShaderParts } from './uniforms.js'

/** Writes functions for the fragment stage. They return no NaN. */
function helpers(language: Language) {
  const {
    fn,
    local,
    choose: pick,
    derivatives: [dx, dy],
    type,
  } = language
  const vec3 = type('vec3')
  return `${fn('vec3', 'warpjetUnit', { direction: 'vec3', otherwise: 'vec3' })} {
${local('float', 'size', 'max(max(abs(direction.x), abs(direction.y)), abs(direction.z))')}
if (size > 0.0 && size < 3e38) { return normalize(direction / size); }
return otherwise;
}
${fn('vec3', 'warpjetFacing', { position: 'vec3', toEye: 'vec3' })} {
${local('vec3', 'normal', `warpjetUnit(cross(${dx}(position), ${dy}(position)), toEye)`)}
return ${pick('dot(normal, toEye) < 0.0', '-normal', 'normal')};
}
${fn('mat3', 'warpjetFrame', { normal: 'vec3', tangent: 'vec3', side: 'float' })} {
${local('vec3', 'axis', pick('abs(normal.x) < 0.9', `${vec3}(1.0, 0.0, 0.0)`, `${vec3}(0.0, 1.0, 0.0)`))}
${local('vec3', 'along', 'warpjetUnit(tangent - dot(normal, tangent) * normal, normalize(cross(normal, axis)))')}
return ${type('mat3')}(along, side * cross(normal, along), normal);
}`
}

/**
 * Returns the code of a plugin for the fragment stage. The keys are places in the shader that Babylon.js has named or, with a leading `!`,
 * regular expressions for the code to replace.
 */
export function fragmentCode(
  parts: ShaderParts,
  texts: PixelTexts | undefined,
  isWGSL: boolean,
): Record<string, string> {
  const language = languageOf(isWGSL)
  const declarations = choose(texts, (each) =>
    [
      ...declareImages(parts, isWGSL),
      sharedDeclarations(each, language),
      each.text.declarations,
    ].join('\n'),
  )
  return {
    CUSTOM_FRAGMENT_DEFINITIONS: ifDefined('WARPJET', `${helpers(language)}\n${declarations}`),
    // In WGSL a variable cannot hide the varying, which is a member of a structure. So we replace each read of the varying, by
    // warpjetTBN if the shader has the tangent frame, and otherwise by the varying itself.
    ...(isWGSL && {
      '!(?:input|fragmentInputs)\\.vTBN([012])': `\n${ifDefined(normalDefines.frame, 'warpjetTBN[$1]', 'fragmentInputs.vTBN$1')}`,
    }),
    [normalLines[isWGSL ? 'wgsl' : 'glsl']]: normalCode(parts, texts, isWGSL),
    ...(parts.warp.mirrors !== false && frontFacingCode(isWGSL)),
  }
}

/** The line in the shaders of materials that reads the interpolated normal, before maps and the side of the triangle change it. */
const normalLines = {
  glsl: '!vec3\\s+normalW\\s*=\\s*normalize\\(vNormalW\\);',
  wgsl: '!var\\s+normalW\\s*:\\s*vec3f\\s*=\\s*normalize\\((?:fragmentInputs|input)\\.vNormalW\\);',
}

/** A variable of the fragment stage whose presence shows that Babylon.js has found this line. */
export const marker = 'warpjetWorldNormal'

function normalCode(parts: ShaderParts, texts: PixelTexts | undefined, isWGSL: boolean) {
  const language = languageOf(isWGSL)
  const { local, input, frontFacing, type, isZero, frame } = language
  const zero = `${type('vec3')}(0.0)`
  const reverse = '{ warpjetFacingNormal = -warpjetFacingNormal; }'
  const unitNormal = 'warpjetUnit(warpjetWorldNormal, warpjetFacingNormal)'
  const vertexFrame = [
    local('mat3', 'warpjetTBN', frame),
    `if (${isZero('warpjetTBN[2]')}) { warpjetTBN = warpjetFrame(normalW, ${zero}, 1.0); }`,
  ].join('\n')
  const pixelFrame = local(
    'mat3',
    'warpjetTBN',
    'warpjetFrame(normalW, warpjetWorldTangent, warpjetSide)',
  )
  const code = [
    // In front of the branches, since screen-space derivatives are undefined in them.
    local('vec3', 'warpjetFacingNormal', `warpjetFacing(${input('vPositionW')}, viewDirectionW)`),
    // Later in the shader, Babylon.js reverses the normals of back sides.
    ifDefined(
      'TWOSIDEDLIGHTING',
      ifDefined('MIRRORED', `if (${frontFacing}) ${reverse}`, `if (!${frontFacing}) ${reverse}`),
    ),
    local('vec3', marker, input('vNormalW')),
    ifDefined(
      normalDefines.frame,
      [local('vec3', 'warpjetWorldTangent', zero), local('float', 'warpjetSide', '1.0')].join('\n'),
    ),
    choose(texts, (text) => pixelBlock(parts, text, isWGSL)),
    local('vec3', 'normalW', unitNormal),
    ifDefined(
      normalDefines.frame,
      [
        ifDefined(normalDefines.pixel, pixelFrame, vertexFrame),
        // This variable hides the varying.
        isWGSL ? '' : 'mat3 vTBN = warpjetTBN;',
      ].join('\n'),
    ),
  ].join('\n')
  return ifDefined('WARPJET', code, local('vec3', 'normalW', `normalize(${input('vNormalW')})`))
}

/** Returns a block that sets the normal and, if a tangent frame is needed, the tangent, both in world space. */
function pixelBlock(parts: ShaderParts, { text, varyings }: PixelText, isWGSL: boolean) {
  const { local, input, choose: pick, type } = languageOf(isWGSL)
  const readInput = ({ input: name, name: varying, type: size }: Varying) => {
    const value = input(varying)
    return name === 'normal'
      ? local('vec3', names[name]!, restoreLength(value))
      : local(size, names[name]!, value)
  }
  // The cofactor matrix of the cofactor matrix is the matrix itself, times its determinant.
  const tangent = [
    local('mat3', 'warpjetDirections', 'warpjetCofactors(warpjetNormals)'),
    `warpjetSide = ${sideOf('warpjetNormals[0]', 'warpjetDirections[0]', pick)};`,
    `warpjetWorldTangent = warpjetSide * (warpjetDirections * ${shaderNames.tangent}.xyz);`,
    `warpjetSide *= ${shaderNames.tangent}.w;`,
  ]
  return [
    '{',
    ...localUniforms(parts, isWGSL),
    ...varyings.map(readInput),
    text.code,
    local('mat3', 'warpjetNormals', `${type('mat3')}(${worldColumns.map(input)})`),
    `${marker} = warpjetNormals * ${shaderNames.normal};`,
    ifDefined(normalDefines.frame, tangent.join('\n')),
    '}',
  ].join('\n')
}

/** Corrects which side of a triangle is the front. Without this, the outer sides count as back sides if the warp mirrors all of space. */
const frontFacingCode = (isWGSL: boolean): Record<string, string> =>
  isWGSL
    ? {
        '!fragmentInputs\\.frontFacing': `(fragmentInputs.frontFacing == (uniforms.${shaderNames.orientation} > 0.0))`,
      }
    : { '!\\bgl_FrontFacing\\b': `(gl_FrontFacing == (${shaderNames.orientation} > 0.0))` }
