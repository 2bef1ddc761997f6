// Kinds of values that a caller may pass: the name in messages, the accepted values, and the default.
import { describe } from '../errors/errors.js'
import { isCallable, isList } from './guards.js'
import type { Place } from './place.js'

export interface Kind<Value, Given = Value> {
  /** Returns the value that a user passed, or the default. Throws a `WarpError` for a wrong value. */
  read(given: unknown, place: Place): Value
  /** Never present at run time: carries the type of values that users may pass. */
  readonly given?: (value: Given) => Given
}

export type ValueOf<Any> = Any extends Kind<infer Value, any> ? Value : never
export type InputOf<Any> = Any extends Kind<any, infer Given> ? Given : never

interface Settings<Value> {
  /** Replaces `undefined`. Without a default, the value is required. */
  default?: Value | undefined
  /** Returns what to write instead of a wrong value. */
  advice?: (given: unknown) => string | undefined
}

/** Makes a kind whose values are returned unchanged. `expected` is its name in messages. */
export const kind = <Value, Given = Value>(
  expected: string,
  accepts: (given: unknown) => boolean,
  { default: standard, advice }: Settings<Value> = {},
): Kind<Value, Given> => ({
  read(given, place) {
    if (given === undefined && standard !== undefined) return standard
    if (accepts(given)) return given as Value
    throw place.expected(expected, describe(given), advice?.(given))
  },
})

/** Makes an optional kind: a missing value is read as `undefined`. */
export const optional = <Value, Given>({
  read,
}: Kind<Value, Given>): Kind<Value | undefined, Given> => ({
  read: (given, place) => (given === undefined ? undefined : read(given, place)),
})

/** Any value, which the caller checks. */
export const anything = <Value>(): Kind<Value | undefined, Value> => ({
  read: (given) => given as Value | undefined,
})

export const boolean = (standard?: boolean) =>
  kind<boolean>('true or false', (given) => typeof given === 'boolean', { default: standard })

export const oneOf = <const Choice extends string>(
  choices: readonly Choice[],
  standard?: NoInfer<Choice>,
) =>
  kind<Choice>(listOf(choices), (given) => choices.includes(given as Choice), { default: standard })

/** Lists up to three choices as `'offset' or 'position'`, and more as `one of a, b, c, d`. */
const listOf = (choices: readonly string[]) =>
  choices.length > 3
    ? `one of ${choices.join(', ')}`
    : choices
        .map((choice) => `'${choice}'`)
        .join(', ')
        .replace(/, (?=[^,]*$)/, ' or ')

/** A string. `what` is its name in messages, such as `the name of a function`. */
export const text = (what = 'a text', matches = /(?:)/, settings: Settings<string> = {}) =>
  kind<string>(what, (given) => typeof given === 'string' && matches.test(given), settings)

interface Range {
  min?: number
  max?: number
  /** The name of the maximum in messages. Default: the number. */
  maxName?: string
  default?: number
}

const hasNumber = (given: unknown, min: number, max: number) =>
  typeof given === 'number' && given >= min && given <= max

export const wholeNumber = ({ min = 0, max = Infinity, maxName, default: standard }: Range) =>
  kind<number>(
    `a whole number ${max === Infinity ? `of at least ${min}` : `from ${min} to ${maxName ?? max}`}`,
    (given) => Number.isInteger(given) && hasNumber(given, min, max),
    { default: standard },
  )

/** A number above 0, which may be infinite if `max` is. */
export const positiveNumber = ({ max = Number.MAX_VALUE, default: standard }: Range = {}) =>
  kind<number>('a number above 0', (given) => given !== 0 && hasNumber(given, 0, max), {
    default: standard,
  })

/** A function. `what` is its name in messages, such as `a function from a URI to bytes`. */
export const callable = <F extends Function>(what = 'a function', settings: Settings<F> = {}) =>
  kind<F>(what, isCallable, settings)

/** The callback that `compile`, `compileWarp` and the like require. */
export const callback = callable('a function', {
  advice: (given) =>
    typeof given === 'string' && given.includes('{')
      ? 'glslOffset(text) of warpjet/glsl makes a function of one in GLSL'
      : undefined,
})

/** An object that is not an array. `what` is its name in messages. */
export const record = <Value extends object>(what: string, settings: Settings<Value> = {}) =>
  kind<Value>(
    what,
    (given) => typeof given === 'object' && given !== null && !isList(given),
    settings,
  )
