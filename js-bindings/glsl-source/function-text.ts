// Writes code that the compiler does not generate, in each language: whole functions, and conversions of variables to floats.
import { targets, type Target } from '../core/module/serialized-module.js'
import { languages } from '../wasm/tables.js'
import type { Named } from './listing.js'
import { wgslType } from './options.js'

export interface FunctionParts {
  name: string
  type: string
  parameters: readonly Named[]
  /** Statements that declare and set `result`. */
  code: string
  /** Source above the function. */
  declarations: string
  result: string
}

export function functionText(target: Target, parts: FunctionParts): string {
  const { name, type, parameters, code, declarations, result } = parts
  const isWgsl = target === 'wgsl'
  const listed = parameters
    .map((each) => (isWgsl ? `${each.name}: ${wgslType(each.type)}` : `${each.type} ${each.name}`))
    .join(', ')
  const head = isWgsl ? `fn ${name}(${listed}) -> ${wgslType(type)}` : `${type} ${name}(${listed})`
  const body = `${code.trimEnd()}\nreturn ${result};`.replace(/^(?=.)/gm, '  ')
  return `${declarations}${head} {\n${body}\n}\n`
}

/** The input `instance` in GLSL. */
export const instanceID = 'gl_InstanceID'

/** Returns expressions that convert a variable, or with `half` the low or high 16 bits of its integers, to floats. */
export function textsAsFloats(
  name: string,
  type: string,
  half: 'low' | 'high' | undefined,
): Record<Target, string> {
  const [size = ''] = /\d/.exec(type) ?? []
  const isUnsigned = type.startsWith('u')
  /** In WGSL, bitwise operands of vectors must be vectors, and shift counts unsigned. */
  const wgslNumber = (number: number, isUnsigned: boolean) =>
    size ? `vec${size}${isUnsigned ? 'u' : 'i'}(${number})` : `${number}${isUnsigned ? 'u' : ''}`
  const part = (number: (number: number, isUnsigned: boolean) => string, shift: boolean) => {
    if (half === 'low') return `${name} & ${number(0xffff, isUnsigned)}`
    return half === 'high' ? `${name} >> ${number(16, shift)}` : name
  }
  const glsl = `${size ? `vec${size}` : 'float'}(${part((number, isUnsigned) => `${number}${isUnsigned ? 'u' : ''}`, isUnsigned)})`
  const wgsl = `${size ? `vec${size}f` : 'f32'}(${part(wgslNumber, true)})`
  const texts = { glsl, wgsl }
  return Object.fromEntries(targets.map((target) => [target, texts[languages[target]]])) as Record<
    Target,
    string
  >
}
