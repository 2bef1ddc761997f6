// From an offset function to the text of its warp.
import { createBuilder, operationNumber } from './builder.js'
import type { Compilation } from './compilation.js'
import { type Compiled, type CompileOptions, withCompilation } from './compiled.js'
import { isExpression } from './describe.js'
import { WarpError, describe, describeShape } from './errors.js'
import { type Expression, toExpression } from './expression.js'
import {
  type InputName,
  drawInputs,
  inputSizes,
  variationInputs,
  variationNames,
  vertexInputs,
} from './inputs.js'
import { noteApproximation } from './notes.js'
import { checkCallback, checkOptions } from './options.js'
import type { Variable } from './shapes.js'
import type { OffsetFunction, UniformOptions, UniformValues, WarpInputs } from './types.js'
import { type DeclaredUniforms, readDeclared, withUniforms } from './uniforms.js'

export interface WarpOptions<
  Uniforms extends UniformValues = UniformValues,
> extends CompileOptions {
  /** What the offset function reads as `uniforms`, with the values that count on the CPU unless others are given; your
   * shader declares and sets them, under the same names. */
  uniforms?: UniformOptions<Uniforms>
  /** The host shader's expression for each input; its name unless given. */
  names?: Partial<Record<InputName, string>>
  /** The names of the results: `warpedPosition`, `warpedNormal`, `warpedTangent` and `offset` unless given. */
  outputs?: { position?: string; normal?: string; tangent?: string; offset?: string }
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
}

/** An offset function as shader text. */
export interface WarpText extends Compiled {
  /** The inputs that are read and are the same for a whole draw call: millis, mouse, size,
   * pixelDensity, and the sketch's own parameters. */
  uniforms: string[]
  /** The inputs that are read and differ by vertex: position, normal, uv, color, tangent, and those of
   * `surfaceVariation`. */
  attributes: string[]
}

/** For the public function `method`: the text, and the sketch's own parameters. */
export function compileWarpText(method: string, given: OffsetFunction, options: WarpOptions) {
  const settings = readOptions(method, given, options)
  const { offset } = declareUniforms(method, given, options)
  return withCompilation(settings.target, (compilation) => {
    const { text, parameters, isApproximate } = buildWarp(compilation, method, offset, settings)
    return { text, parameters, isApproximate }
  })
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

type Settings = ReturnType<typeof readOptions>

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
  ])
  checkOptions(`${method} names`, options.names, Object.keys(inputSizes))
  checkOptions(`${method} outputs`, options.outputs, ['position', 'normal', 'tangent', 'offset'])
  const { target, normals = true, tangents = false, surfaceVariation = false } = options
  for (const [name, value] of Object.entries({ normals, tangents, surfaceVariation }))
    if (typeof value !== 'boolean')
      throw new WarpError(
        `${method}: the option "${name}" must be true or false, but is ${describe(value)}.`,
      )
  if (tangents && !normals)
    throw new WarpError(
      `${method}: tangents are turned with the normal; leave "normals: false" out.`,
    )
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
  const isAccepted = options.surfaceVariation === false
  return { target, normals, tangents, surfaceVariation, isAccepted, names, outputs }
}

/** What the text does not read has a name that no sketch has; the CPU may read it. */
const hidden = (name: string) => `_warpjet_${name}`

const withoutGaps = <Options extends object>(options?: Options) =>
  Object.fromEntries(
    Object.entries(options ?? {}).filter(([, value]) => value !== undefined),
  ) as Options

export interface BuiltWarp {
  text: WarpText
  /** The sketch's own. */
  parameters: Variable[]
  /** By input, the host's expression. */
  names: Record<string, string>
  inputs: Record<string, Expression>
  moved: Expression
  /** What the warp makes of tangents of the surface, over which normal and uv vary; unless the normal is left out. */
  deformation: Expression | undefined
  /** Whether the turn depends on how normal and uv vary over the surface. */
  varies: boolean
  /** Whether they may count as constant nevertheless. */
  isAccepted: boolean
  /** Whether they do in the text, and nobody said that this will do. */
  isApproximate: boolean
}

/** Calls the offset function and writes the text. The compilation stays open for more. */
export function buildWarp(
  compilation: Compilation,
  method: string,
  offsetFunction: OffsetFunction,
  { names, outputs, normals, tangents, surfaceVariation, isAccepted }: Settings,
): BuiltWarp {
  const inputs: Record<string, Expression> = {}
  for (const [name, label] of Object.entries(names)) {
    const size = inputSizes[name as InputName]
    inputs[name] = compilation.input(label, [1, size], `${method} names.${name}`)
  }
  const { position, normal, tangent } = inputs as Record<string, Expression>
  const offset = checkOffset(compilation, method, offsetFunction(warpInputs(compilation, inputs)))

  const operate = operations(compilation)
  const place = `${method} outputs`
  compilation.output(outputs.offset, offset, place)
  const moved = operate('add', position, offset)
  compilation.outputSum(outputs.position, moved, position!, 0, place)
  const varying = variationNames.map((_, i) =>
    i < 3 ? part(compilation, normal!, i) : part(compilation, inputs.uv!, i - 3),
  )
  // Most warps read neither, and then there is nothing to derive.
  const readsIn = [normal, inputs.uv].map(
    (input) => normals && compilation.dependsOn(offset, input!),
  )
  const read = varying.map(
    (input, i) => readsIn[i < 3 ? 0 : 1]! && compilation.dependsOn(offset, input),
  )
  const constant = normals ? operate('deformation', offset, position) : undefined
  const whole = () =>
    variationNames.reduce(
      (deformation, name, i) =>
        read[i] ? operate('varied', offset, deformation, varying[i], inputs[name]) : deformation,
      constant!,
    )
  if (constant) {
    const deformation = surfaceVariation ? whole() : constant
    const turned = operate('turnNormal', deformation, normal)
    compilation.output(outputs.normal, turned, place)
    if (tangents)
      compilation.output(
        outputs.tangent,
        turnTangent(compilation, deformation, tangent!, turned),
        place,
      )
  }

  const { code, declarations, stats, inputs: given } = compilation.build()
  const used = new Set(given.map(({ name }) => name))
  const isRead = (name: string) => used.has(names[name]!)
  const labels = new Set(Object.values(names))
  const parameters = given.filter(({ name }) => !labels.has(name))
  const drawn = Object.keys(drawInputs).filter(isRead)
  refuseNamesakes(method, names, drawn, parameters)
  const text = {
    code,
    declarations,
    stats,
    uniforms: [...drawn, ...parameters.map(({ name }) => name)],
    attributes: Object.keys(vertexInputs).filter(isRead),
  }
  const deformation = constant && whole()
  const varies = variationNames.some(
    (name, i) => read[i] && compilation.dependsOn(deformation!, inputs[name]!),
  )
  const isApproximate = varies && !surfaceVariation && !isAccepted
  return { text, parameters, names, inputs, moved, deformation, varies, isAccepted, isApproximate }
}

/** A parameter under the name of an input that the shader calls otherwise: both would be one uniform. */
function refuseNamesakes(
  method: string,
  labels: Record<string, string>,
  inputs: readonly string[],
  parameters: readonly Variable[],
) {
  for (const { name } of parameters)
    if (inputs.includes(name))
      throw new WarpError(
        `${method}: the shader's "${name}" has the name of the input ${name}, which the warp reads as "${labels[name]}"; rename it.`,
      )
}

/** For `compileWarp`. */
export function noteIfApproximate({ isApproximate }: { isApproximate: boolean }) {
  if (isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
}

const part = (compilation: Compilation, vector: Expression, i: number) =>
  compilation.swizzle('xyz'[i]!, vector, [i])

/** A vec4 as it came, but for the direction. */
export function turnTangent(
  compilation: Compilation,
  deformation: Expression,
  tangent: Expression,
  turned: Expression,
): Expression {
  const operate = operations(compilation)
  const direction = compilation.swizzle('xyz', tangent, [0, 1, 2])
  return operate(
    'vec4',
    operate('turnTangent', deformation, direction, turned),
    compilation.swizzle('w', tangent, [3]),
  )
}

/** Operations of a compilation by name. */
export const operations =
  (compilation: Compilation) =>
  (name: string, ...operands: (Expression | undefined)[]): Expression =>
    compilation.call(operationNumber(name), name, operands as Expression[])

function warpInputs(compilation: Compilation, inputs: Record<string, Expression>): WarpInputs {
  const given = Object.entries(inputs).filter(
    ([name]) => name !== 'tangent' && !(name in variationInputs),
  )
  const { mouse, size } = inputs as Record<string, Expression>
  return {
    glsl: createBuilder(compilation),
    ...Object.fromEntries(given),
    mouseX: part(compilation, mouse!, 0),
    mouseY: part(compilation, mouse!, 1),
    width: part(compilation, size!, 0),
    height: part(compilation, size!, 1),
  } as unknown as WarpInputs
}

function checkOffset(compilation: Compilation, method: string, offset: unknown): Expression {
  const expected = 'the offset function must return a vec3, such as glsl.vec3(x, y, z)'
  if (!isExpression(offset))
    throw new WarpError(`${method}: ${expected}, but returned ${describe(offset)}.`)
  const vector = toExpression(compilation, method, offset, 'the offset')
  const [columns, rows] = compilation.shapeOf(vector)
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${method}: ${expected}, but returned ${describeShape([columns, rows])}.`)
  // A condition becomes 0 or 1 here, as it does in any sum.
  return operations(compilation)('add', vector, compilation.constant(0, method))
}
