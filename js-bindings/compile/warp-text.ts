// From an offset function to the module of its warp, once, and from there to texts.
import { callable, createBuilder, operationNumber } from '../core/expression/builder.js'
import {
  type Compiled,
  type CompileOptions,
  type Declared,
  declared,
  declaredOf,
  withSession,
} from '../core/module/result.js'
import { type Session, resultName } from '../core/expression/session.js'
import { isExpression } from '../errors/describe.js'
import { WarpError, describe, describeShape } from '../errors/errors.js'
import { type Expression, toExpression } from '../core/expression/expression.js'
import {
  type InputName,
  drawInputs,
  inputSizes,
  variationInputs,
  vertexInputs,
} from '../core/inputs/inputs.js'
import {
  type KeptModule,
  type Known,
  type Target,
  checkTarget,
  resultsOf,
  writeText,
} from '../core/module/kept-module.js'
import { lazyObject } from '../core/lazy-object.js'
import { didYouMean, refusing } from '../errors/nearest.js'
import { checkCallback, checkOptions } from '../options/options.js'
import type {
  OffsetFunction,
  UniformOptions,
  UniformValues,
  WarpInputs,
} from '../core/types/types.js'
import type { Variable } from '../core/expression/shapes.js'
import { turnedResults, warpOperands, warpResults } from '../wasm/tables.js'
import {
  type DeclaredUniforms,
  readDeclared,
  withUniforms,
} from '../core/inputs/declared-uniforms.js'

/** The host shader's expression for each input; its name unless given. */
export type InputNames = Partial<Record<InputName, string>>

/** The names of the results: `warpedPosition`, `warpedNormal`, `warpedTangent` and `offset` unless given. */
export interface OutputNames {
  position?: string
  normal?: string
  tangent?: string
  offset?: string
}

export interface WarpOptions<
  Uniforms extends UniformValues = UniformValues,
> extends CompileOptions {
  /** What the offset function reads as `uniforms`, with the values that count on the CPU unless others are given; your
   * shader declares and sets them, under the same names. */
  uniforms?: UniformOptions<Uniforms>
  /** What your shader calls the inputs, as in `{ position: 'aPosition' }`; each by its own name unless given. */
  names?: InputNames
  /** What the text calls the results, as in `{ position: 'moved' }`. */
  outputs?: OutputNames
  /** `false` leaves the normal out. */
  normals?: boolean
  /** `true` also turns the tangent, a vec4 as in glTF. */
  tangents?: boolean
  /**
   * `true`: the shader has the attributes `normalXGradient`, `normalYGradient`, `normalZGradient`, `uGradient` and
   * `vGradient`, vec3s that say how normal and uv vary over the surface, as `surfaceVariation` of 'warpjet/mesh' computes
   * them; the text reads those that the offset makes it need. Otherwise normal and uv count as constant; `false` says that this will do.
   */
  surfaceVariation?: boolean
  /**
   * `true`: what is the same for a whole frame is computed on the CPU, in double, by `frameUniforms`, and the text reads it as
   * uniforms `warpjetFrame0`, …: then float32 keeps its digits however long a page runs.
   */
  perFrame?: boolean
  /** `true`: comments say which lines of the sketch each statement comes from. */
  debug?: boolean
}

/** An offset function as shader text. */
export interface WarpText extends Compiled {
  /** The inputs that are read and are the same for a whole draw call: millis, mouse, size,
   * pixelDensity, and the sketch's own parameters. */
  uniforms: Declared[]
  /** The inputs that are read and differ by vertex: position, normal, uv, color, tangent, and those of
   * `surfaceVariation`. */
  attributes: Declared[]
}

/** Reads the option `uniforms`; gives them to the offset function. */
export function declareUniforms(
  method: string,
  offset: OffsetFunction,
  { uniforms, names = {} }: WarpOptions,
): { offset: OffsetFunction; declared: DeclaredUniforms } {
  const declared = readDeclared(method, uniforms)
  for (const [input, name] of Object.entries(names))
    if (declared.has(name))
      throw new WarpError(
        `${method}: the uniform "${name}" has the name that the option "names" gives to ${input}; rename one of them.`,
      )
  return { offset: withUniforms(method, offset, declared), declared }
}

export type Settings = ReturnType<typeof readOptions>

/** Checks what the caller hands in, and fills in what is left out. */
export function readOptions(method: string, offset: OffsetFunction, options: WarpOptions) {
  checkCallback(method, offset)
  checkOptions(method, options, [
    'uniforms',
    'target',
    'names',
    'outputs',
    'normals',
    'tangents',
    'surfaceVariation',
    'perFrame',
    'debug',
  ])
  checkNames(method, options)
  const { normals = true, tangents = false, surfaceVariation = false } = options
  const { perFrame = false, debug = false } = options
  const choices = { normals, tangents, surfaceVariation, perFrame, debug }
  for (const [name, value] of Object.entries(choices))
    if (typeof value !== 'boolean')
      throw new WarpError(
        `${method}: the option "${name}" must be true or false, but is ${describe(value)}.`,
      )
  if (tangents && !normals)
    throw new WarpError(
      `${method}: tangents are turned with the normal; leave "normals: false" out.`,
    )
  const isAccepted = options.surfaceVariation === false
  const target = checkTarget(options.target)
  const shown = { normals, tangents, surfaceVariation }
  return { method, target, debug, ...shown, isAccepted, ...readNames(shown, options) }
}

type Shown = Record<'normals' | 'tangents' | 'surfaceVariation', boolean>

function readNames(
  { tangents, surfaceVariation }: Shown,
  options: { names?: InputNames | undefined; outputs?: OutputNames | undefined },
) {
  const names: Record<string, string> = {}
  for (const name of Object.keys(inputSizes)) {
    const isLeftOut = name === 'tangent' ? !tangents : name in variationInputs && !surfaceVariation
    names[name] = isLeftOut ? hidden(name) : (options.names?.[name as InputName] ?? name)
  }
  const outputs = {
    offset: 'offset',
    position: 'warpedPosition',
    normal: 'warpedNormal',
    tangent: 'warpedTangent',
    ...withoutGaps(options.outputs),
  }
  return { names, outputs }
}

export function checkNames(method: string, { names, outputs }: TextOptions) {
  checkOptions(`${method} names`, names, Object.keys(inputSizes))
  checkOptions(`${method} outputs`, outputs, ['position', 'normal', 'tangent', 'offset'])
}

/** What the text does not read has a name that no sketch has; the CPU may read it. */
const hidden = (name: string) => `_warpjet_${name}`

const withoutGaps = <Options extends object>(options?: Options) =>
  Object.fromEntries(
    Object.entries(options ?? {}).filter(([, value]) => value !== undefined),
  ) as Options

/** What is kept of an offset function. */
export interface KeptWarp {
  module: KeptModule
  settings: Settings
  /** By input, its number in the module. */
  inputs: Record<string, number>
  /** Whether the turn depends on how normal and uv vary over the surface. */
  varies: boolean
  /** Whether they count as constant in the text, and nobody said that this will do. */
  isApproximate: boolean
  /** The number of the offset's Jacobian, which `writeMoves` writes, if that was asked for. */
  jacobian: number | undefined
}

/** The number of a result where normal and uv vary over the surface. */
export const onSurface = (result: number) =>
  result < warpResults.normal ? result : result + turnedResults

/** Calls the offset function. `moves`: for `writeMoves` too. */
export function keepWarp(
  offsetFunction: OffsetFunction,
  settings: Settings,
  { moves = false } = {},
): KeptWarp {
  const { method, target, names, normals, surfaceVariation, isAccepted, debug } = settings
  const record = (session: Session): KeptWarp => {
    const given: Record<string, Expression> = {}
    for (const [name, label] of Object.entries(names)) {
      given[name] = session.input(
        label,
        [1, inputSizes[name as InputName]],
        `${method} names.${name}`,
      )
      session.inputNames.set(label, name)
    }
    const offset = checkOffset(session, method, offsetFunction(warpInputs(session, given)))
    const operands = warpOperands.map((name) => given[name]!)
    const { varies } = session.warp(method, [offset, ...operands], normals, !surfaceVariation)
    const inputs = Object.fromEntries(
      Object.entries(given).map(([name, input]) => [name, session.numberOf(input)]),
    )
    const isApproximate = varies && !surfaceVariation && !isAccepted
    if (moves) askJacobian(session, offset, given.position!)
    const module = session.finish()
    const jacobian = moves ? resultsOf(module).length - 1 : undefined
    return { module, settings, inputs, varies, isApproximate, jacobian }
  }
  return withSession(target, record, { debug })
}

function askJacobian(session: Session, offset: Expression, position: Expression) {
  const operation = operationNumber('jacobian')
  session.output('jacobian', session.call(operation, 'jacobian', [offset, position]), 'jacobian')
}

/** What a text is written with, unless as the warp was compiled. */
export interface TextOptions {
  names?: InputNames | undefined
  outputs?: OutputNames | undefined
  /** @internal */
  known?: Known | undefined
}

/** A text, and the sketch's own parameters that it reads. */
export interface Written {
  text: WarpText
  parameters: Variable[]
}

export function writeWarp(kept: KeptWarp, target: Target, options: TextOptions = {}): Written {
  const { settings } = kept
  const { method, normals, tangents, surfaceVariation } = settings
  const names = { ...settings.names, ...withoutGaps(options.names) }
  const outputs = { ...settings.outputs, ...withoutGaps(options.outputs) }
  checkMerged(kept.inputs, settings.names, names)
  const isWanted = { offset: true, position: true, normal: normals, tangent: tangents }
  const results = (Object.keys(isWanted) as (keyof typeof isWanted)[])
    .filter((name) => isWanted[name])
    .map((name): [number, string] => [
      surfaceVariation ? onSurface(warpResults[name]) : warpResults[name],
      resultName(outputs[name], `${method} outputs`),
    ])
  return writeResults(kept, target, { names, results, known: options.known })
}

/** For what has no surface: the position, and the Jacobian of the offset, J, since a direction t becomes t + J t. */
export const writeMoves = (
  kept: KeptWarp,
  target: Target,
  outputs: Record<'position' | 'jacobian', string>,
  { names, known }: Pick<TextOptions, 'names' | 'known'> = {},
): Written =>
  writeResults(kept, target, {
    names: { ...kept.settings.names, ...withoutGaps(names) },
    results: [
      [warpResults.position, outputs.position],
      [kept.jacobian!, outputs.jacobian],
    ],
    known,
  })

function writeResults(
  { module, settings, inputs }: KeptWarp,
  target: Target,
  {
    names,
    results,
    known,
  }: {
    names: Record<string, string>
    results: readonly (readonly [number, string])[]
    known: Known | undefined
  },
): Written {
  // A plain name is in the module as it was when the offset was recorded.
  const given = Object.entries(inputs)
    .filter(([name]) => names[name] !== settings.names[name] || !/^\w+$/.test(names[name]!))
    .map(([name, number]): [number, string] => [number, names[name]!])
  const {
    code,
    declarations,
    stats,
    inputs: read,
  } = writeText(module, target, {
    inputs: given,
    results,
    known,
  })
  const numbers = new Set(Object.values(inputs))
  const others = read.filter(({ number }) => !numbers.has(number))
  const ofFrame = others.filter(isOfFrame)
  const parameters = others.filter((variable) => !isOfFrame(variable))
  const among = (sizes: Record<string, number>) =>
    Object.keys(sizes).flatMap((name) => {
      const input = read.find(({ number }) => number === inputs[name])
      return input ? declared({ ...input, name }) : []
    })
  const uniforms = among(drawInputs)
  refuseNamesakes(settings.method, names, uniforms, parameters)
  const attributes = among(vertexInputs)
  return {
    text: {
      code,
      declarations,
      stats,
      uniforms: [...uniforms, ...declaredOf([...ofFrame, ...parameters])],
      attributes,
    },
    parameters,
  }
}

/** The vec4s of compile/frame.ts. */
export const isOfFrame = ({ name }: { name: string }) => /^warpjetFrame\d+$/.test(name)

/** A parameter under the name of an input that the shader calls otherwise: both would be one uniform. */
function refuseNamesakes(
  method: string,
  labels: Record<string, string>,
  inputs: readonly Declared[],
  parameters: readonly Variable[],
) {
  const taken = new Set(inputs.map(({ name }) => name))
  for (const { name } of parameters)
    if (taken.has(name))
      throw new WarpError(
        `${method}: the shader's "${name}" has the name of the input ${name}, which the warp reads as "${labels[name]}"; rename it.`,
      )
}

/** Inputs that had one name when the function was called are one. */
function checkMerged(
  inputs: Record<string, number>,
  were: Record<string, string>,
  are: Record<string, string>,
) {
  const first = new Map<number, string>()
  for (const [name, number] of Object.entries(inputs)) {
    const other = first.get(number) ?? name
    first.set(number, other)
    if (are[name] !== are[other])
      throw new WarpError(
        `emit: ${other} and ${name} were one input, "${were[name]}", when the offset was compiled; give both one name again, or compile it with these names.`,
      )
  }
}

const part = (session: Session, vector: Expression, i: number) =>
  session.swizzle('xyz'[i]!, vector, [i])

/** What other shaders call inputs. */
const meant = {
  time: 'millis',
  frameCount: 'millis',
  texCoord: 'uv',
  texcoord: 'uv',
  vertex: 'position',
  pos: 'position',
  resolution: 'size',
}

/** The inputs that an offset function gets under their own names. */
const givenNames = Object.keys(inputSizes).filter(
  (name) => name !== 'tangent' && !(name in variationInputs),
)

/** Components that have names of their own. */
const namedParts = {
  mouseX: ['mouse', 0],
  mouseY: ['mouse', 1],
  width: ['size', 0],
  height: ['size', 1],
} as const

const offsetInputs = new Map(
  ['glsl', ...givenNames, ...Object.keys(namedParts)].map((name) => [name, true]),
)

function warpInputs(session: Session, inputs: Record<string, Expression>): WarpInputs {
  // Also for an offset that does not read it: it gives expressions their methods.
  const glsl = createBuilder(session)
  const make = (name: string) => {
    if (name === 'glsl') return glsl
    const [vector, i] = namedParts[name as keyof typeof namedParts] ?? []
    // p5 has millis(), and a component may be called too.
    return callable(name, vector ? part(session, inputs[vector]!, i!) : inputs[name]!)
  }
  const names = [...offsetInputs.keys()]
  const unknown = (name: string) =>
    `An offset function gets no "${name}"; ${didYouMean(name, names, `it gets ${names.join(', ')}, and uniforms by the option "uniforms".`, meant)}`
  return lazyObject(refusing(unknown), { names: offsetInputs, make }) as WarpInputs
}

function checkOffset(session: Session, method: string, offset: unknown): Expression {
  const expected = 'the offset function must return a vec3, such as glsl.vec3(x, y, z)'
  if (!isExpression(offset))
    throw new WarpError(
      `${method}: ${expected}, but returned ${describe(offset)}${offset === undefined ? ' (is its "return" missing?)' : offset instanceof Promise ? ' (leave its "async" out)' : ''}.`,
    )
  const vector = toExpression(session, method, offset, 'the offset')
  const [columns, rows] = session.shapeOf(vector)
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${method}: ${expected}, but returned ${describeShape([columns, rows])}.`)
  return vector
}
