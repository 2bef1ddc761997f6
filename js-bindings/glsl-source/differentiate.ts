// `differentiate`: a function of shader text as the text of one that gives its derivatives too.
import { compile } from '#text-compiler'
import { anything, kind, optional, text } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { type KindsOf, object } from '../options/schema.js'
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { type Target, targetKind } from '../core/module/serialized-module.js'
import type { Vector } from '../core/types/types.js'
import { bindExternals, parameterOf } from './bind.js'
import { functionText } from './function-text.js'
import { type FunctionHead, type Listing, type Named, withSource } from './listing.js'
import { type GlslOptions, article, glslKinds, sourceKind } from './options.js'
import { pack, replay } from './replay.js'

export interface DifferentiateOptions extends GlslOptions {
  /** The parameter to differentiate by, a float or a vector; the first one unless given. */
  by?: string
  /** The language of the new text; `'glsl300'` unless given. */
  target?: Target
  /** What the new function is called; that of the function, and `Gradient` or `Jacobian`, unless given. */
  name?: string
}

const place = new Place('differentiate')
const differentiateOptions = object({
  ...glslKinds,
  by: anything<string>(),
  target: targetKind,
  name: optional(text('the name of a function', /^[a-z_]\w*$/i)),
} satisfies KindsOf<DifferentiateOptions>)

/**
 * The text of a function with the parameters of the one in `source`. Where that gives a float, the new one,
 * `…Gradient`, gives a vector of the value and then its derivatives by each component of `by`: `vec4 mapGradient(vec3 p)`
 * of a distance field. Where it gives a vector, `…Jacobian` gives the matrix of its derivatives, a column for each
 * component of `by`, or a vector if `by` is a float.
 *
 * Uniforms stay the shader's. Throws a `WarpError` with the line and column of what is wrong in the text.
 */
export function differentiate(source: string, options?: DifferentiateOptions): string {
  const sourceText = sourceKind.read(source, place.part('the source'))
  const given = differentiateOptions.read(options, place)
  const { target } = given
  const { by, shape, listing } = withSource(place, sourceText, (open) => {
    const head = open.find(given.function)
    const by = parameterNamed(head, given.by)
    const shape = resultShape(head, by, target)
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

/** What an expression such as `lights[0].color` is a part of. */
const rootOf = ({ name }: Named) => /^\w*/.exec(name)![0]

/** A parameter that has the name of a uniform would hide it, which another function of the text may read. */
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

/** For the output: of no parameter and no uniform. */
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
  /** Whether the value comes before its derivatives. */
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
  // Floats, as resultShape says.
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

/** The name of the parameter to differentiate by. */
function parameterNamed({ name, parameters }: FunctionHead, by: unknown): string {
  const names = parameters.map((each) => each.name)
  if (names.length === 0) throw place.error(`${name} has no parameter to differentiate by.`)
  return kind<string>(
    `a parameter of ${name}, one of ${names.join(', ')},`,
    (given) => names.includes(given as string),
    { default: names[0]! },
  ).read(by, place.option('by'))
}

/** The type of the result. Throws if there is none. */
function resultShape(
  { name, type, parameters }: FunctionHead,
  by: string,
  target: Target,
): ResultShape {
  const refuse = (why: string): never => {
    throw place.error(`${why}.`)
  }
  const isFloats = (word: string) => /^(?:float|vec[234])$/.test(word)
  for (const each of parameters)
    if (
      each.isOut ||
      !/^(?:float|u?int|bool|vec[234]|mat[234](?:x[234])?)$/.test(each.type) ||
      each.name === '?'
    )
      refuse(
        each.isOut
          ? `the parameter ${each.name} of ${name} is out; return a value`
          : `the parameter ${each.name} of ${name} is ${article(each.type)}, which nothing can be given for`,
      )
  const wide = parameters.find((each) => /x/.test(each.type))
  if (wide && target === 'glsl100')
    refuse(`glsl100 has no ${wide.type}, which the parameter ${wide.name} is; take glsl300 or wgsl`)
  const input = parameters.find((each) => each.name === by)!.type
  if (!isFloats(input))
    refuse(`${by} is ${article(input)}; only a float or a vector can be differentiated by`)
  if (!isFloats(type))
    refuse(`${name} gives ${article(type)}; only a float or a vector has derivatives here`)
  const sizeOf = (word: string) => (word === 'float' ? 1 : Number(word.at(-1)))
  const [from, to] = [sizeOf(input), sizeOf(type)]
  if (to === 1) {
    if (from === 4)
      refuse(`value and gradient by a vec4 are five numbers, which no vector holds; split ${by}`)
    return { type: `vec${from + 1}`, isValue: true }
  }
  if (from === 1) return { type: `vec${to}`, isValue: false }
  if (from !== to && target === 'glsl100')
    refuse(`glsl100 has no matrix of ${from} columns and ${to} rows; take glsl300 or wgsl`)
  return { type: from === to ? `mat${to}` : `mat${from}x${to}`, isValue: false }
}
