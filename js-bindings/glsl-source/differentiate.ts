// `differentiate`: generates the source of a function that returns the derivatives of another.
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
 * Returns the source of a function with the same parameters as the one in `source`. If that returns a float, the new one,
 * `…Gradient`, returns a vector of the value and its derivatives with respect to each component of `by`: `vec4 mapGradient(vec3 p)` for
 * a distance field. If it returns a vector, `…Jacobian` returns the matrix of its derivatives, with a column for each
 * component of `by`, or a vector if `by` is a float.
 *
 * Uniforms remain uniforms of the shader. Throws a `WarpError` with the line and column of a mistake in the source.
 */
export function differentiate(source: string, options?: DifferentiateOptions): string {
  const given = differentiateOptions.read(options, place)
  const { language } = given
  const text = sourceKinds[language].read(source, place.part('the source'))
  const target = given.target ?? (language === 'wgsl' ? 'wgsl' : 'glsl300')
  const { by, shape, listing } = withSource(place, { text, language }, (open) => {
    const head = open.find(given.function)
    const by = parameterNamed(head, given.by)
    const shape = resultShape(head, by, target, language)
    return { by, shape, listing: open.list(head, given.maxIterations) }
  })
  const { head } = listing
  const parameters = renameParameters(listing)
  const name = given.name ?? head.name + (shape.isValue ? 'Gradient' : 'Jacobian')
  const result = freeName(listing)
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

/** Returns the variable that an expression such as `lights[0].color` is part of. */
const rootOf = ({ name }: Named) => /^\w*/.exec(name)![0]

/** Renames parameters with the name of a uniform, since they would hide it from other functions of the source that read it. */
function renameParameters({ head, externals }: Listing): Named[] {
  const taken = new Set([...head.parameters, ...externals].map(rootOf))
  const hidden = new Set(externals.filter((each) => each.isRead).map(rootOf))
  return head.parameters.map((each) => {
    let { name } = each
    for (let i = 2; hidden.has(each.name) && taken.has(name); i++) name = `${each.name}${i}`
    taken.add(name)
    return { ...each, name }
  })
}

/** Returns a name for the output that no parameter or uniform has. */
function freeName({ head, externals }: Listing): string {
  const taken = new Set([...head.parameters, ...externals].map(rootOf))
  const name = ['result', 'outcome', 'derivatives'].find((each) => !taken.has(each))
  if (name) return name
  let number = 2
  while (taken.has(`result${number}`)) number++
  return `result${number}`
}

interface ResultShape {
  type: string
  /** True if the value precedes its derivatives. */
  isValue: boolean
}

function derivativesOf(
  glsl: Builder,
  listing: Listing,
  parameters: readonly Named[],
  by: string,
  { isValue }: ResultShape,
): Expression {
  const { head, externals } = listing
  const operands = parameters.map((each) => parameterOf(place, glsl, each))
  const outside = bindExternals(place, glsl, externals, {})
  const value = pack(glsl, head.type, replay(glsl, listing, { arguments: operands, ...outside }))
  const index = head.parameters.findIndex(({ name }) => name === by)
  // The parameter has floats, as resultShape checks.
  const input = operands[index] as Expression
  const isNumber = head.parameters[index]!.type === 'float'
  if (isNumber) {
    const slope = glsl.derivative!(value, input)
    return isValue ? glsl.vec2!(value, slope) : slope
  }
  if (!isValue) return glsl.jacobian!(value, input)
  const slopes = glsl.gradient!(value, input) as unknown as Vector
  const size = Number(head.parameters[index]!.type.at(-1))
  return glsl[`vec${size + 1}`]!(value, slopes)
}

/** Returns the name of the parameter to differentiate by. */
function parameterNamed({ name, parameters }: FunctionHead, by: unknown): string {
  const names = parameters.map((each) => each.name)
  if (names.length === 0) throw place.error(`${name} has no parameter to differentiate by.`)
  return kind<string>(
    `a parameter of ${name}, one of ${names.join(', ')},`,
    (given) => names.includes(given as string),
    { default: names[0]! },
  ).read(by, place.option('by'))
}

/** Returns the type of the result. Throws if the function is unsupported. */
function resultShape(
  { name, type, parameters }: FunctionHead,
  by: string,
  target: Target,
  language: SourceLanguage,
): ResultShape {
  const article = (type: string) => articleIn(language, type)
  const reject = (why: string): never => {
    throw place.error(`${why}.`)
  }
  const isFloats = (word: string) => /^(?:float|vec[234])$/.test(word)
  for (const each of parameters)
    if (
      each.isOut ||
      !/^(?:float|u?int|bool|vec[234]|mat[234](?:x[234])?)$/.test(each.type) ||
      each.name === '?'
    )
      reject(
        each.isOut
          ? `the parameter ${each.name} of ${name} is out; return a value`
          : `the parameter ${each.name} of ${name} is ${article(each.type)}, which is unsupported`,
      )
  const wide = parameters.find((each) => /x/.test(each.type))
  if (wide && target === 'glsl100')
    reject(
      `glsl100 lacks ${wide.type}, the type of the parameter ${wide.name}; use glsl300 or wgsl`,
    )
  const input = parameters.find((each) => each.name === by)!.type
  if (!isFloats(input))
    reject(`${by} is ${article(input)}; expected a float or a vector to differentiate by`)
  if (!isFloats(type)) reject(`${name} returns ${article(type)}; expected a float or a vector`)
  const sizeOf = (word: string) => (word === 'float' ? 1 : Number(word.at(-1)))
  const [from, to] = [sizeOf(input), sizeOf(type)]
  if (to === 1) {
    if (from === 4)
      reject(`value and gradient by a vec4 are five numbers, too many for a vector; split ${by}`)
    return { type: `vec${from + 1}`, isValue: true }
  }
  if (from === 1) return { type: `vec${to}`, isValue: false }
  if (from !== to && target === 'glsl100')
    reject(`glsl100 has no matrix of ${from} columns and ${to} rows; use glsl300 or wgsl`)
  return { type: from === to ? `mat${to}` : `mat${from}x${to}`, isValue: false }
}
