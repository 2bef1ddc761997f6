/**
 * Code of the vertex stage for normals at pixels. This code passes the inputs of the warp as varyings. The fragment stage, in
 * fragment-normals.ts, runs the same warp on their interpolated values, but computes only the normal and, for normal maps, the tangent.
 */
import { withLength, type HostText } from '../compile/hosts.js'
import { ifDefined, languageOf, type Language } from './language.js'
import { names, normalDefines, textOf } from './names.js'
import type { ShaderParts } from './uniforms.js'

export interface Varying {
  input: string
  name: string
  type: 'vec2' | 'vec3' | 'vec4'
}

export interface PixelText {
  text: HostText
  varyings: readonly Varying[]
}

/** The code at pixels, once with the tangent frame and once with only the normal. */
export interface PixelTexts {
  frame: PixelText
  normal: PixelText
}

export function pixelTextsOf({ warp }: ShaderParts, isWGSL: boolean): PixelTexts {
  const write = (...results: ('normal' | 'tangent')[]): PixelText => {
    const text = textOf(warp, 'fragment', results, isWGSL)
    const varyings = text.attributes.map(({ name, type }) => ({
      input: name,
      name: `warpjetPixel_${name}`,
      // The fourth component is the length of the normal, since interpolation shortens the normal.
      type: name === 'normal' ? 'vec4' : (type as Varying['type']),
    }))
    return { text, varyings }
  }
  return { frame: write('normal', 'tangent'), normal: write('normal') }
}

/** Varyings for the columns of the matrix that transforms normals from the warp's space to world space. */
export const worldColumns = ['warpjetWorld0', 'warpjetWorld1', 'warpjetWorld2']

/** Counts the vectors that the code passes to pixels. */
export const countVaryings = ({ varyings }: PixelText) => varyings.length + worldColumns.length

/**
 * Writes code for both texts. The preprocessor selects one by the defines of the mesh. If normals are not computed at pixels, the
 * preprocessor drops both.
 */
export const choose = (texts: PixelTexts | undefined, write: (text: PixelText) => string) =>
  texts
    ? ifDefined(
        normalDefines.pixel,
        ifDefined(normalDefines.frame, write(texts.frame), write(texts.normal)),
      )
    : ''

/** Returns the declarations that both stages have. */
export const sharedDeclarations = ({ varyings }: PixelText, language: Language) =>
  [
    ...varyings.map(({ type, name }) => language.declareVarying(type, name)),
    ...worldColumns.map((name) => language.declareVarying('vec3', name)),
    cofactors(language),
  ].join('\n')

const cofactors = (language: Language) =>
  `${language.fn('mat3', 'warpjetCofactors', { m: 'mat3' })} {
return ${language.type('mat3')}(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
}`

export const vertexDefinitions = (texts: PixelTexts | undefined, isWGSL: boolean) =>
  choose(texts, (text) => sharedDeclarations(text, languageOf(isWGSL)))

/** Returns statements that pass the inputs of the warp to pixels. */
export function passInputs(texts: PixelTexts | undefined, isWGSL: boolean) {
  const { output, type } = languageOf(isWGSL)
  return choose(texts, ({ varyings }) =>
    varyings
      .map(({ input, name }) => {
        const value = names[input]!
        return `${output(name)} = ${input === 'normal' ? withLength(value, type('vec4')) : value};`
      })
      .join('\n'),
  )
}

/**
 * Returns statements for the end of the vertex stage. They pass the matrix for normals to pixels, and set the normal to zero again where
 * Babylon.js has normalized a zero normal to NaN; the fragment stage tests for zero.
 */
export function vertexEnd(texts: PixelTexts | undefined, isWGSL: boolean) {
  const { local, linear, choose: pick, output, isZero, type, clearFrame } = languageOf(isWGSL)
  // finalWorld includes the transforms of instances and bones, which the fragment stage does not know.
  const columns = [
    '{',
    local('mat3', 'warpjetColumns', `warpjetCofactors(${linear('finalWorld')})`),
    local('float', 'warpjetSide', sideOf('finalWorld[0].xyz', 'warpjetColumns[0]', pick)),
    ...worldColumns.map((name, i) => `${output(name)} = warpjetSide * warpjetColumns[${i}];`),
    '}',
  ].join('\n')
  const collapsed = [
    `if (${isZero('normalUpdated')}) { ${output('vNormalW')} = ${type('vec3')}(0.0); }`,
    ifDefined(
      normalDefines.frame,
      `if (${isZero('normalUpdated')} || ${isZero('tangentUpdated.xyz')}) { ${clearFrame} }`,
    ),
  ].join('\n')
  return ifDefined(
    'WARPJET',
    ifDefined(
      'NORMAL',
      [texts ? ifDefined(normalDefines.pixel, columns) : '', collapsed].join('\n'),
    ),
  )
}

/** Returns an expression that is -1 for a matrix that mirrors and otherwise 1, from the first columns of the matrix and its cofactors. */
export const sideOf = (column: string, cofactors: string, pick: Language['choose']) =>
  pick(`dot(${column}, ${cofactors}) < 0.0`, '-1.0', '1.0')
