// `differentiate`: generates the source of a function that returns the derivatives of another function.
import { compile } from '#text-compiler'
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { targetKind, type Target } from '../core/module/serialized-module.js'
import type { Vector } from '../core/types/types.js'
import { anything, kind, oneOf, optional, text } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { bindExternals, parameterOf } from './bind.js'
import { functionText } from './function-text.js'
import { withSource, type FunctionHead, type Listing, type Named } from './listing.js'
import {
  articleIn,
  glslKinds,
  sourceKinds,
  type GlslOptions,
  type SourceLanguage,
} from './options.js'
import { pack, replay } from './replay.js'

export interface DifferentiateOptions extends GlslOptions {
  /** The parameter to differentiate by, a float or a vector. Default: the first parameter. */
  by?: string
  /**
   * The language of the source.
   * @default 'glsl'
   */
  language?: SourceLanguage
  /** The language of the new function. Default: `'glsl300'`, or `'wgsl'` for a source in WGSL. */
  target?: Target
  /** The name of the new function. Default: the name of the original, followed by `Gradient` or `Jacobian`. */
  name?: string
}

const place = new Place('differentiate')
const differentiateOptions = object({
  ...glslKinds,
  by: anything<string>(),
  language: oneOf<SourceLanguage>(['glsl', 'wgsl'], 'glsl'),
  target: optional(targetKind),
  name: optional(text('the name of a function', /^[a-z_]\w*$/i)),
} satisfies KindsOf<DifferentiateOptions>)

/**
 * Returns the source of a function with the same parameters as the function in `source`. For a function that returns a float, the new one,
 * `…Gradient`, returns a vector of the value and its derivatives with respect to each component of `by`: `vec4 mapGradient(vec3 p)` for
 * a distance field. For a function that returns a vector, the new one, `…Jacobian`, returns the matrix of its derivatives, with a column
 * for each component of `by`; if `by` is a float, a vector.
 *
 * Uniforms remain uniforms of the shader. Throws a `WarpError` with the line and column of a mistake in the source.
 */
export function differentiate(source: string, options?: DifferentiateOptions): string {
  const settings = differentiateOptions.read(options, place)
  const { language } = settings
  const text = sourceKinds[language].read(source, place.part('the source'))
  const target = settings.target ?? (language === 'wgsl' ? 'wgsl' : 'glsl300')
  const { by, shape, listing } = withSource(place, { text, language }, (openSource) => {
    const head = openSource.find(settings.function)
    const by = readBy(head, settings.by)
    const shape = resultShape(head, by, target, language)
    return { by, shape, listing: openSource.list(head, settings.maxIterations) }
  })
  const { head } = listing
  const parameters = renameParameters(listing)
  const name = settings.name ?? head.name + (shape.hasValue ? 'Gradient' : 'Jacobian')
  const result = unusedName(listing)
  const compiled = compile(
    (glsl) => ({
      [result]: derivativesOf(glsl as unknown as Builder, listing, parameters, by, shape) as never,
    }),
    { target },
  )
  return functionText(target, {
    ...compiled,
    result,
    name,
    type: shape.type,
    parameters,
  })
}

/** Returns the name of the variable in an expression such as `lights[0].color`. */
const rootOf = ({ name }: Named) => /^\w*/.exec(name)![0]

/** Returns the parameters, renamed where they have the name of a uniform that is read: in the new function, they would hide it. */
function renameParameters({ head, externals }: Listing): Named[] {
  const usedNames = new Set([...head.parameters, ...externals].map(rootOf))
  const readNames = new Set(externals.filter(({ isRead }) => isRead).map(rootOf))
  return head.parameters.map((parameter) => {
    let { name } = parameter
    for (let i = 2; readNames.has(parameter.name) && usedNames.has(name); i++)
      name = `${parameter.name}${i}`
    usedNames.add(name)
    return { ...parameter, name }
  })
}

/** Returns a name for the result that no parameter or uniform has. */
function unusedName({ head, externals }: Listing): string {
  const usedNames = new Set([...head.parameters, ...externals].map(rootOf))
  const name = ['result', 'outcome', 'derivatives'].find((each) => !usedNames.has(each))
  if (name) return name
  let suffix = 2
  while (usedNames.has(`result${suffix}`)) suffix++
  return `result${suffix}`
}

interface ResultShape {
  type: string
  /** True if the result begins with the value of the original function, which the derivatives follow. */
  hasValue: boolean
}

function derivativesOf(
  glsl: Builder,
  listing: Listing,
  parameters: readonly Named[],
  by: string,
  { hasValue }: ResultShape,
): Expression {
  const { head, externals } = listing
  const operands = parameters.map((parameter) => parameterOf(place, glsl, parameter))
  const boundExternals = bindExternals(place, glsl, externals, {})
  const numbers = replay(glsl, listing, { arguments: operands, ...boundExternals })
  const value = pack(glsl, head.type, numbers)
  const index = head.parameters.findIndex(({ name }) => name === by)
  // The parameter is a float or a vector of floats, as resultShape checks.
  const input = operands[index] as Expression
  const isNumber = head.parameters[index]!.type === 'float'
  if (isNumber) {
    const slope = glsl.derivative!(value, input)
    return hasValue ? glsl.vec2!(value, slope) : slope
  }
  if (!hasValue) return glsl.jacobian!(value, input)
  const slopes = glsl.gradient!(value, input) as unknown as Vector
  const size = Number(head.parameters[index]!.type.at(-1))
  return glsl[`vec${size + 1}`]!(value, slopes)
}

/** Reads the option `by`: returns the name of the parameter to differentiate by. */
function readBy({ name, parameters }: FunctionHead, by: unknown): string {
  const names = parameters.map((parameter) => parameter.name)
  if (names.length === 0) throw place.error(`${name} has no parameter to differentiate by.`)
  return kind<string>(
    `a parameter of ${name}, one of ${names.join(', ')},`,
    (value) => names.includes(value as string),
    { default: names[0]! },
  ).read(by, place.option('by'))
}

/** Returns the type of the new function's result. Throws if the original function is unsupported. */
function resultShape(
  { name, type, parameters }: FunctionHead,
  by: string,
  target: Target,
  language: SourceLanguage,
): ResultShape {
  const article = (type: string) => articleIn(language, type)
  const reject = (reason: string): never => {
    throw place.error(`${reason}.`)
  }
  const isFloatOrVector = (type: string) => /^(?:float|vec[234])$/.test(type)
  for (const parameter of parameters)
    if (
      parameter.isOut ||
      !/^(?:float|u?int|bool|vec[234]|mat[234](?:x[234])?)$/.test(parameter.type) ||
      parameter.name === '?'
    )
      reject(
        parameter.isOut
          ? `the parameter ${parameter.name} of ${name} is ${language === 'wgsl' ? 'a pointer' : 'an out parameter'}; return a value instead`
          : `the parameter ${parameter.name} of ${name} is ${article(parameter.type)}, which is unsupported`,
      )
  const nonSquare = parameters.find((parameter) => /x/.test(parameter.type))
  if (nonSquare && target === 'glsl100')
    reject(
      `glsl100 lacks ${nonSquare.type}, the type of the parameter ${nonSquare.name}; use glsl300 or wgsl`,
    )
  const inputType = parameters.find((parameter) => parameter.name === by)!.type
  if (!isFloatOrVector(inputType))
    reject(`${by} is ${article(inputType)}; expected a float or a vector to differentiate by`)
  if (!isFloatOrVector(type))
    reject(`${name} returns ${article(type)}; expected a float or a vector`)
  const sizeOf = (type: string) => (type === 'float' ? 1 : Number(type.at(-1)))
  const [inputSize, size] = [sizeOf(inputType), sizeOf(type)]
  if (size === 1) {
    if (inputSize === 4)
      reject(
        `the value and its derivatives by a vec4 are five numbers, too many for a vector; split ${by}`,
      )
    return { type: `vec${inputSize + 1}`, hasValue: true }
  }
  if (inputSize === 1) return { type: `vec${size}`, hasValue: false }
  if (inputSize !== size && target === 'glsl100')
    reject(`glsl100 has no matrix of ${inputSize} columns and ${size} rows; use glsl300 or wgsl`)
  return {
    type: inputSize === size ? `mat${size}` : `mat${inputSize}x${size}`,
    hasValue: false,
  }
}
