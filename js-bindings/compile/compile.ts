// Any expressions, as text and on the CPU: `compile`, and glsl-autodiff's `gen`.
import { createBuilder } from '../core/expression/builder.js'
import type { Session } from '../core/expression/session.js'
import { WarpError, describe } from '../errors/errors.js'
import { readOperators } from '../errors/operators.js'
import {
  type Compiled,
  type CompileOptions,
  declaredOf,
  withSession,
} from '../core/module/result.js'
import { type Numbers, evaluate } from '../cpu/double.js'
import { Expression, toExpression } from '../core/expression/expression.js'
import {
  type KeptModule,
  checkTarget,
  makeProgram,
  resultsOf,
  writeText,
} from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { checkCallback, checkOptions } from '../options/options.js'
import type { Expression as AnyExpression, Glsl } from '../core/types/types.js'

export interface CompiledExpressions extends Compiled {
  /**
   * The expressions on the CPU, in double, from the values of the host's variables by name: a number each, or an array
   * for a vector or, column by column, a matrix. Conditions are 1 and 0. Throws a `WarpError` if a value is missing or
   * of the wrong size, or if a `glsl.fn` or `glsl.texture` is called, which only the GPU can run.
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
  const target = checkTarget(options.target)
  const read = readOperators(callback, { method: 'compile' })
  const module = withSession(target, (session) => {
    const results: unknown = read(createBuilder(session) as unknown as Glsl)
    if (typeof results !== 'object' || results === null || isNoRecord(results))
      throw new WarpError(
        `compile: the function must return an object of named expressions, such as { height: x.sin() }, but returned ${describeResult(results)}.`,
      )
    for (const [name, value] of Object.entries(results)) {
      const expression = toExpression(session, 'compile', value, `the result "${name}"`)
      session.output(name, expression, 'compile')
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
    uniforms: declaredOf(inputs),
    evaluate: (given = {}) => evaluate(cpu().program, inputs, cpu().outputs, given),
  }
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
  const { maxDepthPerVariable, debug = false } = settings
  if (
    maxDepthPerVariable !== undefined &&
    !(typeof maxDepthPerVariable === 'number' && maxDepthPerVariable >= 1)
  )
    throw new WarpError(
      `gen: maxDepthPerVariable must be a number of at least 1, but is ${describe(maxDepthPerVariable)}.`,
    )
  const target = checkTarget(settings.target)
  const read = readOperators(callback, { method: 'gen' })
  const run = (session: Session): [KeptModule, unknown] => {
    const returned: unknown = read(createBuilder(session) as unknown as Glsl)
    if (isUnfinished(returned))
      throw new WarpError('gen: the function must be a plain one, not async and no generator.')
    return [session.finish(), returned]
  }
  const [module, returned] = withSession(target, run, { asks: true, debug })
  const { code, declarations } = writeText(module, target, {}, maxDepthPerVariable)
  if (declarations.includes('warpjet'))
    throw new WarpError(
      'gen: noise and images need functions above main, which only compile gives.',
    )
  if (returned !== undefined && code === '')
    throw new WarpError(
      'gen: no result was asked for; call .output(name) on an expression instead of returning it.',
    )
  return code
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
