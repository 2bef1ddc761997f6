// Puts the warp into vertex shaders of Babylon.js, whose names for the position, normal and so on are the same in GLSL and in WGSL: into
// those of a material by the code of a plugin, into those of passes by changing their source.
import {
  shaderNames,
  variationAttribute,
  variationNames,
  type HostText,
  type HostWarp,
} from '../compile/hosts.js'
import { ifDefined, ifNotDefined } from './language.js'
import { names, textOf, variationDefines } from './names.js'
import { passInputs, vertexDefinitions, vertexEnd, type PixelTexts } from './pixel-normals.js'
import {
  declareAttribute,
  declareImages,
  declareUniform,
  localUniforms,
  orientationUniform,
  sentUniforms,
  type ShaderParts,
} from './uniforms.js'

const sizes: Record<string, number> = { float: 1, vec2: 2, vec3: 3, vec4: 4, mat4: 16 }

/** Returns the uniforms, as a plugin's `getUniforms` must return them. */
export function declarationsOf(parts: ShaderParts, hasPixels: boolean, isWGSL: boolean) {
  const orientation = parts.warp.mirrors !== false ? [orientationUniform] : []
  const all = [...sentUniforms(parts), ...orientation]
  const declare = (uniform: (typeof all)[number]) => `${declareUniform(uniform, false)}\n`
  return {
    ubo: all.map(({ name, type }) => ({ name, type, size: sizes[type]! })),
    // For engines without uniform buffers.
    ...(!isWGSL && {
      vertex: all.map(declare).join(''),
      fragment: (hasPixels ? all : orientation).map(declare).join(''),
    }),
  }
}

/** Returns the code for vertices with a normal and a tangent, with only a normal, and with neither. */
function textsOf(warp: HostWarp, isWGSL: boolean): [HostText, HostText, HostText] {
  const text = (...results: ('normal' | 'tangent')[]) =>
    textOf(warp, 'vertex', ['offset', 'position', ...results], isWGSL)
  return [text('normal', 'tangent'), text('normal'), text()]
}

/** Returns the code of the vertex stage for a plugin's `getCustomCode`. */
export function vertexCode(parts: ShaderParts, pixels: PixelTexts | undefined, isWGSL: boolean) {
  const texts = textsOf(parts.warp, isWGSL)
  const choose = (write: (text: HostText, i: number) => string) => {
    const [withTangent, withNormal, withNeither] = texts.map(write)
    return ifDefined('NORMAL', ifDefined('TANGENT', withTangent!, withNormal), withNeither)
  }
  const color = isWGSL ? 'let warpjetColor = ' : 'vec4 warpjetColor = '
  return {
    CUSTOM_VERTEX_DEFINITIONS: [
      ...declareImages(parts, isWGSL),
      ifDefined(
        'WARPJET',
        [
          declareVariation(isWGSL),
          choose(({ declarations }) => declarations),
          vertexDefinitions(pixels, isWGSL),
        ].join('\n'),
      ),
    ].join('\n'),
    CUSTOM_VERTEX_UPDATE_NORMAL: ifDefined(
      'WARPJET',
      [
        '{',
        ...localUniforms(parts, isWGSL),
        variationLocals(isWGSL),
        readsColor(texts[0])
          ? ifDefined('VERTEXCOLOR', `${color}colorUpdated;`, `${color}${one(isWGSL)};`)
          : '',
        ifNotDefined('UV1', local('uvUpdated', 2, zero(2, isWGSL), isWGSL)),
        ifNotDefined('NORMAL', local('normalUpdated', 3, zero(3, isWGSL), isWGSL)),
        passInputs(pixels, isWGSL),
        choose(({ code }, i) => `${code}\n${assignments[i]}`),
        '}',
      ].join('\n'),
    ),
    CUSTOM_VERTEX_MAIN_END: vertexEnd(pixels, isWGSL),
  }
}

const zero = (size: number, isWGSL: boolean) => `vec${size}${isWGSL ? 'f' : ''}(0.0)`
const one = (isWGSL: boolean) => `vec4${isWGSL ? 'f' : ''}(1.0)`

/** Declares a variable inside of the warp's block. */
const local = (name: string, size: number, value: string, isWGSL: boolean) =>
  isWGSL ? `let ${name} = ${value};` : `vec${size} ${name} = ${value};`

const readsColor = ({ attributes }: HostText) => attributes.some(({ name }) => name === 'color')

const assignPosition = `positionUpdated = ${shaderNames.position};`
const assignNormal = `normalUpdated = ${shaderNames.normal};`
/** The statements that assign the results, for each of `textsOf`. */
const assignments = [
  `${assignPosition} ${assignNormal} tangentUpdated = ${shaderNames.tangent};`,
  `${assignPosition} ${assignNormal}`,
  assignPosition,
]

/** Returns the define of a mesh that has this vector of the surface variation. */
const variationDefine = (name: string) =>
  name.startsWith('normal') ? variationDefines.normal : variationDefines.uv

const declareVariation = (isWGSL: boolean) =>
  variationNames
    .map((name) =>
      ifDefined(variationDefine(name), declareAttribute(variationAttribute(name), 3, isWGSL)),
    )
    .join('\n')

/** Declares variables for the surface variation; they are 0 for a mesh without it, as if normal and uv were constant. */
const variationLocals = (isWGSL: boolean) =>
  variationNames
    .map((name) => {
      const attribute = `${isWGSL ? 'vertexInputs.' : ''}${variationAttribute(name)}`
      const declare = (value: string) => local(names[name as keyof typeof names], 3, value, isWGSL)
      return ifDefined(variationDefine(name), declare(attribute), declare(zero(3, isWGSL)))
    })
    .join('\n')

/**
 * Maps attributes that the shader of a pass may lack → the defines of its variant: `has` if the mesh has the attribute, `adds` if the variant
 * must also declare it.
 */
export const passDefines = {
  normal: { has: 'WARPJET_HAS_NORMAL', adds: 'WARPJET_ADDS_NORMAL' },
  uv: { has: 'WARPJET_HAS_UV', adds: 'WARPJET_ADDS_UV' },
  color: { has: 'WARPJET_HAS_COLOR', adds: 'WARPJET_ADDS_COLOR' },
}

/**
 * Adds the warp to the vertex shader of a pass, after the code of morph targets and before that of instances and bones. The includes of
 * `source` are resolved. Returns the source unchanged if it is not written like the shaders of Babylon.js.
 */
export function warpPass(parts: ShaderParts, isWGSL: boolean, source: string): string {
  const start = /@vertex|void\s+main\s*\(/.exec(source)
  // The outline pass first displaces vertices along the normal, in `offsetPosition`, so the warp must come before that.
  const end =
    /(vec3|var)\s+offsetPosition\b/.exec(source) ??
    /#ifdef INSTANCES\s+(mat4|var)\s+finalWorld\b/.exec(source)
  if (!start || !end || !/\bpositionUpdated\b/.test(source)) return source
  const hasVariable = (name: string) => new RegExp(`(vec\\d|var)\\s+${name}\\b`).test(source)
  const hasNormal = hasVariable('normalUpdated')
  const [, withNormal, withNeither] = textsOf(parts.warp, isWGSL)
  const text = hasNormal ? withNormal : withNeither
  const declareLocal = (
    name: string,
    kind: 'normal' | 'uv' | 'color',
    size: number,
    otherwise: string,
  ) =>
    ifDefined(
      passDefines[kind].has,
      local(name, size, `${isWGSL ? 'vertexInputs.' : ''}${kind}`, isWGSL),
      local(name, size, otherwise, isWGSL),
    )
  const uv = declareLocal('uvUpdated', 'uv', 2, zero(2, isWGSL))
  const definitions = [
    ...sentUniforms(parts).map((uniform) => declareUniform(uniform, isWGSL)),
    ...declareImages(parts, isWGSL),
    ifDefined(passDefines.normal.adds, declareAttribute('normal', 3, isWGSL)),
    ifDefined(passDefines.uv.adds, declareAttribute('uv', 2, isWGSL)),
    ifDefined(passDefines.color.adds, declareAttribute('color', 4, isWGSL)),
    declareVariation(isWGSL),
    text.declarations,
  ]
  const block = [
    '{',
    ...localUniforms(parts, isWGSL),
    variationLocals(isWGSL),
    readsColor(text) ? declareLocal('warpjetColor', 'color', 4, one(isWGSL)) : '',
    hasVariable('uvUpdated') ? ifNotDefined('UV1', uv) : uv,
    hasNormal ? '' : declareLocal('normalUpdated', 'normal', 3, zero(3, isWGSL)),
    text.code,
    assignments[hasNormal ? 1 : 2],
    '}',
  ]
  return [
    source.slice(0, start.index),
    ...definitions,
    source.slice(start.index, end.index),
    ...block,
    source.slice(end.index),
  ].join('\n')
}
