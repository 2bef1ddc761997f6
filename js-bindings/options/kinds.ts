// Kinds of values that a caller may pass: what a message expects, what is accepted, and the default.
import { describe } from '../errors/errors.js'
import { isCallable, isList } from './guards.js'
import type { Place } from './place.js'

/** Reads a value that a user gave: the result is a `Value`. Throws a `WarpError` for any other. */
export interface Kind<Value, Given = Value> {
  read(given: unknown, place: Place): Value
  /** Always missing: the type of what users may give, for TypeScript. */
  readonly given?: (value: Given) => Given
}

export type ValueOf<Any> = Any extends Kind<infer Value, any> ? Value : never
export type GivenOf<Any> = Any extends Kind<any, infer Given> ? Given : never

interface Settings<Value> {
  /** Stands for `undefined`. Without it, the value is required. */
  default?: Value | undefined
  /** Says what to write instead. */
  advice?: (given: unknown) => string | undefined
}

/** A kind whose values are taken as they are. `expected` is its name in messages. */
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

/** A kind that may be left out. */
export const optional = <Value, Given>({
  read,
}: Kind<Value, Given>): Kind<Value | undefined, Given> => ({
  read: (given, place) => (given === undefined ? undefined : read(given, place)),
})

/** Any value: others read it. */
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

/** Such as `'offset' or 'position'`, and for more than three `one of a, b, c, d`. */
const listOf = (choices: readonly string[]) =>
  choices.length > 3
    ? `one of ${choices.join(', ')}`
    : choices
        .map((choice) => `'${choice}'`)
        .join(', ')
        .replace(/, (?=[^,]*$)/, ' or ')

/** A text; `what` describes it, such as `the name of a function`. */
export const text = (what = 'a text', matches = /(?:)/, settings: Settings<string> = {}) =>
  kind<string>(what, (given) => typeof given === 'string' && matches.test(given), settings)

interface Range {
  min?: number
  max?: number
  /** The name of the limit in messages, where the number itself is hard to read. */
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

/** A function; `what` describes it, such as `a function from a URI to bytes`. */
export const callable = <F extends Function>(what = 'a function', settings: Settings<F> = {}) =>
  kind<F>(what, isCallable, settings)

/** The function that the user hands to a compiler. */
export const callback = callable('a function', {
  advice: (given) =>
    typeof given === 'string' && given.includes('{')
      ? 'glslOffset(text) of warpjet/glsl makes a function of one in GLSL'
      : undefined,
})

/** An object, and no list; `what` describes it. */
export const record = <Value extends object>(what: string, settings: Settings<Value> = {}) =>
  kind<Value>(
    what,
    (given) => typeof given === 'object' && given !== null && !isList(given),
    settings,
  )
