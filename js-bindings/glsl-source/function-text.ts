// Writes code that the compiler does not generate, in GLSL or WGSL: whole functions, and conversions of variables to floats.
import { targets, type Target } from '../core/module/serialized-module.js'
import { languages } from '../wasm/tables.js'
import type { Named } from './listing.js'
import { wgslType } from './options.js'

export interface FunctionParts {
  name: string
  type: string
  parameters: readonly Named[]
  /** Statements that declare and set the variable `result`. */
  code: string
  /** Code above the function. */
  declarations: string
  /** The name of the variable that the function returns. */
  result: string
}

export function functionText(target: Target, parts: FunctionParts): string {
  const { name, type, parameters, code, declarations, result } = parts
  const isWgsl = target === 'wgsl'
  const parameterList = parameters
    .map((each) => (isWgsl ? `${each.name}: ${wgslType(each.type)}` : `${each.type} ${each.name}`))
    .join(', ')
  const head = isWgsl
    ? `fn ${name}(${parameterList}) -> ${wgslType(type)}`
    : `${type} ${name}(${parameterList})`
  const body = `${code.trimEnd()}\nreturn ${result};`.replace(/^(?=.)/gm, '  ')
  return `${declarations}${head} {\n${body}\n}\n`
}

/** The input `instance` in GLSL. */
export const instanceID = 'gl_InstanceID'

/** Returns, for each target, an expression that converts a variable, or with `half` the low or high 16 bits of its integers, to floats. */
export function floatConversions(
  name: string,
  type: string,
  half: 'low' | 'high' | undefined,
): Record<Target, string> {
  const [size = ''] = /\d/.exec(type) ?? []
  const isUnsigned = type.startsWith('u')
  const scalarLiteral = (value: number, isUnsigned: boolean) => `${value}${isUnsigned ? 'u' : ''}`
  /** In WGSL, both operands of a bitwise operation must be vectors if one is, and the number of bits of a shift must be unsigned. */
  const wgslLiteral = (value: number, isUnsigned: boolean) =>
    size ? `vec${size}${isUnsigned ? 'u' : 'i'}(${value})` : scalarLiteral(value, isUnsigned)
  const chosenBits = (
    literal: (value: number, isUnsigned: boolean) => string,
    isShiftUnsigned: boolean,
  ) => {
    if (half === 'low') return `${name} & ${literal(0xffff, isUnsigned)}`
    return half === 'high' ? `${name} >> ${literal(16, isShiftUnsigned)}` : name
  }
  const glsl = `${size ? `vec${size}` : 'float'}(${chosenBits(scalarLiteral, isUnsigned)})`
  const wgsl = `${size ? `vec${size}f` : 'f32'}(${chosenBits(wgslLiteral, true)})`
  const texts = { glsl, wgsl }
  return Object.fromEntries(targets.map((target) => [target, texts[languages[target]]])) as Record<
    Target,
    string
  >
}
