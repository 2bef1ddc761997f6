// From a callback to shader text: builds the graph, asks for results, and closes the compilation.
import { createBuilder, operationNumber } from './builder.js'
import { Compilation, type Target, type Variable } from './compilation.js'
import { WarpError, describe } from './errors.js'
import { type Numbers, evaluate } from './evaluate.js'
import { Expression, toExpression } from './expression.js'
import { checkCallback, checkOptions } from './options.js'
import type { Expression as AnyExpression, Glsl, OffsetFunction, WarpInputs } from './types.js'

/** How much work a result is. */
export interface Stats {
  /** Graph nodes that the results need, constants and inputs included. */
  nodes: number
  /** Those of them that compute something. */
  operations: number
  temporaries: number
}

export interface Compiled {
  /** Statements for the inside of a function; they declare and assign the results. */
  code: string
  /** Functions that `code` calls, for above `main`: the sources of `glsl.fn`, each once. */
  declarations: string
  /** The host's variables and expressions that the statements really read. */
  uniforms: string[]
  stats: Stats
}

export interface CompileOptions {
  /** The shading language; `'glsl300'` unless given. */
  target?: Target
}

const vertexInputs = { position: 3, normal: 3, uv: 2, color: 4 }
const drawInputs = { millis: 1, mouse: 2, size: 2, pixelDensity: 1 }
const inputSizes = { ...vertexInputs, ...drawInputs }

export type InputName = keyof typeof inputSizes

export interface WarpOptions extends CompileOptions {
  /** The host shader's expression for each input; its name unless given. */
  names?: Partial<Record<InputName, string>>
  /** The names of the results: `warpedPosition`, `warpedNormal` and `offset` unless given. */
  outputs?: { position?: string; normal?: string; offset?: string }
  /** `false` leaves the normal out. */
  normals?: boolean
}

export interface CompiledWarp extends Compiled {
  /** The inputs that are read and are the same for a whole draw call: millis, mouse, size,
   * pixelDensity, and the sketch's own parameters. */
  uniforms: string[]
  /** The inputs that are read and differ by vertex: position, normal, uv, color. */
  attributes: string[]
}

/**
 * Compiles an offset function into statements that move a vertex and turn its normal. They declare
 * `vec3 offset, warpedPosition, warpedNormal`; the normal has length 1, or 0 where the warp
 * collapses the surface. `normal`, `uv` and `color` count as constant over the surface: where the
 * offset depends on them, their share of the turn is left out. Throws a `WarpError` if the offset
 * is no function, returns no vec3, or misuses an operation, and for wrong options.
 */
export function compileWarp(offset: OffsetFunction, options: WarpOptions = {}): CompiledWarp {
  return compileWarpFor('compileWarp', offset, options).warp
}

/**
 * The same for another public function, which `method` names in messages; with the sketch's own parameters.
 */
export function compileWarpFor(
  method: string,
  offset: OffsetFunction,
  options: WarpOptions,
): { warp: CompiledWarp; parameters: Variable[] } {
  checkCallback(method, offset)
  checkOptions(method, options, ['target', 'names', 'outputs', 'normals'])
  checkOptions(`${method} names`, options.names, Object.keys(inputSizes))
  checkOptions(`${method} outputs`, options.outputs, ['position', 'normal', 'offset'])
  const { normals = true } = options
  if (typeof normals !== 'boolean')
    throw new WarpError(
      `${method}: the option "normals" must be true or false, but is ${describe(normals)}.`,
    )

  return withCompilation(options.target, false, (compilation) => {
    const labels: Record<string, string> = {}
    const inputs: Record<string, Expression> = {}
    for (const [name, size] of Object.entries(inputSizes)) {
      labels[name] = options.names?.[name as InputName] ?? name
      inputs[name] = compilation.input(labels[name], [1, size], `${method} names.${name}`)
    }
    const { position, normal } = inputs as { position: Expression; normal: Expression }
    const value = checkOffset(compilation, method, offset(warpInputs(compilation, inputs)))

    const {
      offset: offsetName = 'offset',
      position: positionName = 'warpedPosition',
      normal: normalName = 'warpedNormal',
    } = options.outputs ?? {}
    const place = `${method} outputs`
    compilation.output(offsetName, value, place)
    const moved = operate(compilation, 'add', position, value)
    compilation.outputSum(positionName, moved, position, 0, place)
    if (normals)
      compilation.output(
        normalName,
        operate(compilation, 'adjustNormal', value, normal, position),
        place,
      )

    const { code, declarations, stats, inputs: read } = compilation.build()
    const used = read.map(({ name }) => name)
    const isRead = (name: string) => used.includes(labels[name]!)
    const parameters = read.filter(({ name }) => !Object.values(labels).includes(name))
    const warp = {
      code,
      declarations,
      stats,
      uniforms: [...Object.keys(drawInputs).filter(isRead), ...parameters.map(({ name }) => name)],
      attributes: Object.keys(vertexInputs).filter(isRead),
    }
    return { warp, parameters }
  })
}

export interface CompiledExpressions extends Compiled {
  /**
   * The expressions on the CPU, in double, from the values of the host's variables by name: a number each, or an array
   * for a vector or, column by column, a matrix. Conditions are 1 and 0. Throws a `WarpError` if a value is missing or
   * of the wrong size, or if a `glsl.fn` is called, which only the GPU can run.
   */
  evaluate(inputs?: Readonly<Record<string, Numbers>>): Record<string, number | number[]>
}

/**
 * Compiles any named expressions. The callback gets the builder and returns them as an object;
 * `glsl.derivative(expression, input)` is an expression too. Throws a `WarpError`.
 */
export function compile(
  callback: (glsl: Glsl) => Record<string, AnyExpression | number>,
  options: CompileOptions = {},
): CompiledExpressions {
  checkCallback('compile', callback)
  checkOptions('compile', options, ['target'])
  return withCompilation(options.target, false, (compilation) => {
    const results: unknown = callback(createBuilder(compilation) as unknown as Glsl)
    if (typeof results !== 'object' || results === null || isNoRecord(results))
      throw new WarpError(
        `compile: the function must return an object of named expressions, such as { height: x.sin() }, but returned ${describeResult(results)}.`,
      )
    for (const [name, value] of Object.entries(results))
      compilation.output(
        name,
        toExpression(compilation, 'compile', value, `the result "${name}"`),
        'compile',
      )
    const { code, declarations, stats, inputs, outputs } = compilation.build()
    const program = compilation.program()
    return {
      code,
      declarations,
      stats,
      uniforms: inputs.map(({ name }) => name),
      evaluate: (given = {}) => evaluate(program, inputs, outputs, given),
    }
  })
}

export interface GenSettings extends CompileOptions {
  /** The number of nested operations at which an expression becomes a variable. Unless it is given, that is 8, and an
   * expression that reads many variables is cut too, so that few are alive at a time. */
  maxDepthPerVariable?: number
  /** Adds the line of the sketch that each statement comes from. */
  debug?: boolean
}

/**
 * glsl-autodiff's `gen`: the callback asks for results with `.output(name)` and
 * `.outputDeriv(name, input)`, and the statements come back. The source of a `glsl.fn` is not among
 * them; put it above `main`. Throws a `WarpError`.
 */
export function gen(callback: (ad: Glsl) => void, settings: GenSettings = {}): string {
  checkCallback('gen', callback)
  checkOptions('gen', settings, ['target', 'maxDepthPerVariable', 'debug'])
  const { maxDepthPerVariable, debug = false, target } = settings
  if (
    maxDepthPerVariable !== undefined &&
    !(typeof maxDepthPerVariable === 'number' && maxDepthPerVariable >= 1)
  )
    throw new WarpError(
      `gen: maxDepthPerVariable must be a number of at least 1, but is ${describe(maxDepthPerVariable)}.`,
    )
  return withCompilation(target, debug, (compilation) => {
    const returned: unknown = callback(createBuilder(compilation) as unknown as Glsl)
    if (isUnfinished(returned))
      throw new WarpError('gen: the function must be a plain one, not async and no generator.')
    const { code } = compilation.build(maxDepthPerVariable)
    if (returned !== undefined && code === '')
      throw new WarpError(
        'gen: no result was asked for; call .output(name) on an expression instead of returning it.',
      )
    return code
  })
}

/** What an async function or a generator returns at once. */
const isUnfinished = (returned: unknown) =>
  typeof returned === 'object' && returned !== null && ('then' in returned || 'next' in returned)

function describeResult(results: unknown): string {
  if (results instanceof Expression) return 'a single expression'
  if (isUnfinished(results)) return 'before it was finished; it must be a plain function'
  return describe(results)
}

const isNoRecord = (results: object) =>
  results instanceof Expression || Array.isArray(results) || Object.keys(results).length === 0

function withCompilation<Result>(
  target: Target = 'glsl300',
  debug: boolean,
  work: (compilation: Compilation) => Result,
): Result {
  const compilation = new Compilation(target, debug)
  try {
    return work(compilation)
  } finally {
    compilation.close()
  }
}

function warpInputs(compilation: Compilation, inputs: Record<string, Expression>): WarpInputs {
  const part = (name: string, i: number) => compilation.swizzle('xy'[i]!, inputs[name]!, [i])
  return {
    glsl: createBuilder(compilation),
    ...inputs,
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
  const size = columns > 1 ? 'a matrix' : rows > 1 ? `a vec${rows}` : 'a single number'
  if (columns !== 1 || rows !== 3)
    throw new WarpError(`${method}: ${expected}, but returned ${size}.`)
  // A condition becomes 0 or 1 here, as it does in any sum.
  return operate(compilation, 'add', offset, compilation.constant(0, method))
}

function operate(compilation: Compilation, name: string, ...operands: Expression[]): Expression {
  return compilation.call(operationNumber(name), name, operands)
}
