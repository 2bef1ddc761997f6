// Names in the shaders of `exactNormals`.
import { inputTypes } from '../../glsl-source/bind.js'

/** While a shader is read, those of its variables that have the name of an input begin with this prefix. */
export const inputPrefix = 'warpjetInput_'

/** The names of inputs that three.js has as attributes of geometries. */
const attributes = ['position', 'normal', 'uv']

// A constant that is computed from `inputTypes` would bring the front end of GLSL into bundles that only use `warp`.
export const isInputName = (name: string): boolean =>
  name === 'tangent' || (Object.hasOwn(inputTypes, name) && !attributes.includes(name))

/** Restores the names of the variables of a shader. */
export const withNamesOfShader = (text: string) => text.replaceAll(inputPrefix, '')

/** Renames identifiers that begin with warpjet, so that they differ from those of a warp: one shader may contain both. */
export const withExactNames = (source: string) =>
  withNamesOfShader(source).replace(/\bwarpjet(?!Exact)/g, 'warpjetExact')

/** Matches the heads of functions that are generated from functions of the user. Each has the name of the user's function and a hash. */
const head =
  /^(?:(?:high|medium|low)p )?\w+ (?!warpjet)(\w+_[0-9a-z]+(?:Gradient|Jacobian)?)\([^;{]*\) ?\{\n\w+ result;/gm

/** Renames the functions whose heads `head` matches, since a warp in the same shader may have generated the same ones. */
export function withExactFunctions(source: string): string {
  const names = [...source.matchAll(head)].map(([, name]) => name!)
  return names.length === 0
    ? source
    : source.replace(new RegExp(`\\b(?:${names.join('|')})(?=\\()`, 'g'), 'warpjetExact_$&')
}
