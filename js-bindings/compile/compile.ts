// Compiles any expressions, to shader code and for the CPU: `compile`, and glsl-autodiff's `gen`.
import { createBuilder } from '../core/expression/builder.js'
import { Expression, toExpression } from '../core/expression/expression.js'
import type { Session } from '../core/expression/session.js'
import { lazily } from '../core/module/lazily.js'
import {
  uniqueDeclared,
  withSession,
  type CompileOptions,
  type Compiled,
} from '../core/module/result.js'
import {
  makeProgram,
  resultsOf,
  targetKind,
  writeText,
  type SerializedModule,
} from '../core/module/serialized-module.js'
import type { Expression as AnyExpression, Glsl } from '../core/types/types.js'
import { evaluate, type Numbers } from '../cpu/double.js'
import { describe } from '../errors/errors.js'
import { translateOperators } from '../errors/operators.js'
import { boolean, callback as callbackKind, kind, optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'

export interface CompiledExpressions extends Compiled {
  /**
   * Evaluates the expressions on the CPU, in double precision. `inputs` maps a variable of the shader → its value: a number, or an
   * array for a vector or, column by column, a matrix. Conditions are 1 and 0. Throws a `WarpError` if a value is missing or of the
   * wrong size, or if a `glsl.fn` or `glsl.texture` is called, which only the GPU can evaluate.
   */
  evaluate(inputs?: Readonly<Record<string, Numbers>>): Record<string, number | number[]>
}

const place = new Place('compile')
const compileOptions = object({ target: targetKind } satisfies KindsOf<CompileOptions>)

/**
 * Compiles named expressions. The callback gets `glsl` and returns them as an object; `glsl.derivative(expression, input)` is an
 * expression too. Throws a `WarpError` for an operation that is misused, and for a callback that does not return expressions.
 */
export function compile(
  callback: (glsl: Glsl) => Record<string, AnyExpression | number>,
  options: CompileOptions = {},
): CompiledExpressions {
  callbackKind.read(callback, place)
  const { target } = compileOptions.read(options, place)
  const translated = translateOperators(callback, { method: 'compile' })
  const module = withSession(target, (session) => {
    const results: unknown = translated(createBuilder(session) as unknown as Glsl)
    if (typeof results !== 'object' || results === null || !isRecord(results))
      throw place.error(
        `the function must return an object of named expressions, such as { height: x.sin() }, but returned ${describeResult(results)}.`,
      )
    for (const [name, value] of Object.entries(results)) {
      const expression = toExpression(session, value, place.part(`the result "${name}"`))
      session.output(name, expression, place)
    }
    return session.finish()
  })
  const { code, declarations, stats, inputs } = writeText(module, target)
  const cpu = lazily(() => {
    const outputs = resultsOf(module)
    return { outputs, program: makeProgram(module, [...outputs.keys()]) }
  })
  return {
    code,
    declarations,
    stats,
    uniforms: uniqueDeclared(inputs),
    evaluate: (given = {}) => evaluate(cpu().program, inputs, cpu().outputs, given),
  }
}

export interface GenSettings extends CompileOptions {
  /** The number of nested operations at which an expression becomes a variable. Default: 8; by default, expressions that read
   * many variables are also split, so that few variables are live at a time. */
  maxDepthPerVariable?: number
  /** If true, comments say which line of your code each statement comes from. */
  debug?: boolean
}

const genPlace = new Place('gen')
const genSettings = object({
  target: targetKind,
  maxDepthPerVariable: optional(
    kind<number>('a number of at least 1', (given) => typeof given === 'number' && given >= 1),
  ),
  debug: boolean(false),
} satisfies KindsOf<GenSettings>)

/**
 * glsl-autodiff's `gen`: the callback requests results by `.output(name)` and `.outputDeriv(name, input)`. Returns the statements,
 * without the sources of `glsl.fn`; put these above `main`. Throws a `WarpError` for an operation that is misused.
 */
export function gen(callback: (ad: Glsl) => void, settings: GenSettings = {}): string {
  callbackKind.read(callback, genPlace)
  const { target, maxDepthPerVariable, debug } = genSettings.read(settings, genPlace)
  const translated = translateOperators(callback, { method: 'gen' })
  const run = (session: Session): [SerializedModule, unknown] => {
    const returned: unknown = translated(createBuilder(session) as unknown as Glsl)
    if (isUnfinished(returned))
      throw genPlace.error('the function must be neither async nor a generator.')
    return [session.finish(), returned]
  }
  const [module, returned] = withSession(target, run, { hasOutputMethods: true, debug })
  const { code, declarations } = writeText(module, target, {}, maxDepthPerVariable)
  if (declarations.includes('warpjet'))
    throw genPlace.error(
      'noise and images need functions above main; use compile, which returns them.',
    )
  if (returned !== undefined && code === '')
    throw genPlace.error(
      'there is no result; call .output(name) on an expression instead of returning it.',
    )
  return code
}

/** Tests for a promise or a generator object. */
const isUnfinished = (returned: unknown) =>
  typeof returned === 'object' && returned !== null && ('then' in returned || 'next' in returned)

function describeResult(results: unknown): string {
  if (results instanceof Expression) return 'a single expression'
  if (isUnfinished(results))
    return 'a promise or generator; it must be neither async nor a generator'
  return describe(results)
}

const isRecord = (results: object) =>
  !(results instanceof Expression) && !Array.isArray(results) && Object.keys(results).length > 0
