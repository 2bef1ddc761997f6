// From an offset function to the text of its warp.
import { createBuilder, operationNumber } from './builder.js'
import type { Compilation, Variable } from './compilation.js'
import { type Compiled, type CompileOptions, withCompilation } from './compiled.js'
import { WarpError, describe, describeShape } from './errors.js'
import { Expression, toExpression } from './expression.js'
import { type InputName, drawInputs, inputSizes, vertexInputs } from './inputs.js'
import { checkCallback, checkOptions } from './options.js'
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
}

/** An offset function as shader text. */
export interface WarpText extends Compiled {
  /** The inputs that are read and are the same for a whole draw call: millis, mouse, size,
   * pixelDensity, and the sketch's own parameters. */
  uniforms: string[]
  /** The inputs that are read and differ by vertex: position, normal, uv, color, tangent. */
  attributes: string[]
}

/** For the public function `method`: the text, and the sketch's own parameters. */
export function compileWarpText(method: string, given: OffsetFunction, options: WarpOptions) {
  const settings = readOptions(method, given, options)
  const { offset } = declareUniforms(method, given, options)
  return withCompilation(settings.target, false, (compilation) => {
    const { text, parameters } = buildWarp(compilation, method, offset, settings)
    return { text, parameters }
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
  checkOptions(method, options, ['uniforms', 'target', 'names', 'outputs', 'normals', 'tangents'])
  checkOptions(`${method} names`, options.names, Object.keys(inputSizes))
  checkOptions(`${method} outputs`, options.outputs, ['position', 'normal', 'tangent', 'offset'])
  const { target, normals = true, tangents = false } = options
  for (const [name, value] of Object.entries({ normals, tangents }))
    if (typeof value !== 'boolean')
      throw new WarpError(
        `${method}: the option "${name}" must be true or false, but is ${describe(value)}.`,
      )
  if (tangents && !normals)
    throw new WarpError(
      `${method}: tangents are turned with the normal; leave "normals: false" out.`,
    )
  const names: Record<string, string> = {}
  for (const name of Object.keys(inputSizes))
    if (name !== 'tangent' || tangents) names[name] = options.names?.[name as InputName] ?? name
  const outputs = {
    offset: 'offset',
    position: 'warpedPosition',
    normal: 'warpedNormal',
    tangent: 'warpedTangent',
    ...withoutGaps(options.outputs),
  }
  return { target, normals, tangents, names, outputs }
}

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
  offset: Expression
  moved: Expression
  /** Unless the normal is left out. */
  turned: Expression | undefined
}

/** Calls the offset function and writes the text. The compilation stays open for more. */
export function buildWarp(
  compilation: Compilation,
  method: string,
  offsetFunction: OffsetFunction,
  { names, outputs, normals, tangents }: Settings,
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
  const turned = normals ? operate('adjustNormal', offset, normal, position) : undefined
  if (turned) compilation.output(outputs.normal, turned, place)
  if (turned && tangents) {
    const turnedTangent = turnTangent(compilation, { inputs, offset }, tangent!, turned)
    compilation.output(outputs.tangent, turnedTangent, place)
  }

  const { code, declarations, stats, inputs: read } = compilation.build()
  const used = read.map(({ name }) => name)
  const isRead = (name: string) => used.includes(names[name]!)
  const parameters = read.filter(({ name }) => !Object.values(names).includes(name))
  const text = {
    code,
    declarations,
    stats,
    uniforms: [...Object.keys(drawInputs).filter(isRead), ...parameters.map(({ name }) => name)],
    attributes: Object.keys(vertexInputs).filter(isRead),
  }
  return { text, parameters, names, inputs, offset, moved, turned }
}

/** A vec4 as it came, but for the direction. */
export function turnTangent(
  compilation: Compilation,
  { inputs, offset }: Pick<BuiltWarp, 'inputs' | 'offset'>,
  tangent: Expression,
  turned: Expression,
): Expression {
  const operate = operations(compilation)
  const direction = compilation.swizzle('xyz', tangent, [0, 1, 2])
  return operate(
    'vec4',
    operate('adjustTangent', offset, direction, turned, inputs.position),
    compilation.swizzle('w', tangent, [3]),
  )
}

/** Operations of a compilation by name. */
export const operations =
  (compilation: Compilation) =>
  (name: string, ...operands: (Expression | undefined)[]): Expression =>
    compilation.call(operationNumber(name), name, operands as Expression[])

function warpInputs(compilation: Compilation, inputs: Record<string, Expression>): WarpInputs {
  const part = (name: string, i: number) => compilation.swizzle('xy'[i]!, inputs[name]!, [i])
  const { tangent: _, ...given } = inputs
  return {
    glsl: createBuilder(compilation),
    ...given,
    mouseX: part('mouse', 0),
    mouseY: part('mouse', 1),
    width: part('size', 0),
    height: part('size', 1),
  } as unknown as WarpInputs
}

function checkOffset(compilation: Compilation, method: string, offset: unknown): Expression {
  const expected = 'the offset function must return a vec3, such as glsl.vec3(x, y, z)'
  if (!(offset instanceof Expression))
    throw new WarpError(`${method}: ${expected}, but returned ${describe(offset)}.`)
  toExpression(compilation, method, offset, 'the offset')
  const [columns, rows] = compilation.shapeOf(offset)
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${method}: ${expected}, but returned ${describeShape([columns, rows])}.`)
  // A condition becomes 0 or 1 here, as it does in any sum.
  return operations(compilation)('add', offset, compilation.constant(0, method))
}
