// Names in the shaders of `exactNormals`.
import { inputTypes } from '../../glsl-source/bind.js'

/** While a shader is read, its variables with the name of an input begin with this. */
export const inputPrefix = 'warpjetInput_'

const inputs = new Set([...Object.keys(inputTypes), 'tangent'])
for (const name of ['position', 'normal', 'uv']) inputs.delete(name)

export const isInputName = (name: string) => inputs.has(name)

/** Restores the names of the variables of a shader. */
export const withNamesOfShader = (text: string) => text.replaceAll(inputPrefix, '')

/** Renames what begins with warpjet, so that it differs from the names of a warp: one shader may have both. */
export const withExactNames = (source: string) =>
  withNamesOfShader(source).replace(/\bwarpjet(?!Exact)/g, 'warpjetExact')

/** Matches the heads of functions that are made of the user's, which have their names and a hash. */
const head =
  /^(?:(?:high|medium|low)p )?\w+ (?!warpjet)(\w+_[0-9a-z]+(?:Gradient|Jacobian)?)\([^;{]*\) ?\{\n\w+ result;/gm

/** Renames these functions, too. */
export function withExactFunctions(source: string): string {
  const names = [...source.matchAll(head)].map(([, name]) => name!)
  return names.length === 0
    ? source
    : source.replace(new RegExp(`\\b(?:${names.join('|')})(?=\\()`, 'g'), 'warpjetExact_$&')
}
