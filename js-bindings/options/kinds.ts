// A kind describes the values that a caller may pass: their name in messages, which values are accepted, and the default.
import { describe } from '../errors/errors.js'
import { isCallable, isList } from './guards.js'
import type { Place } from './place.js'

export interface Kind<Value, Given = Value> {
  /** Returns the value that a user passed, or the default for `undefined`. Throws a `WarpError` for a wrong value. */
  read(value: unknown, place: Place): Value
  /** Never present at run time: carries the type of values that users may pass. */
  readonly given?: (value: Given) => Given
}

export type ValueOf<Any> = Any extends Kind<infer Value, any> ? Value : never
export type InputOf<Any> = Any extends Kind<any, infer Given> ? Given : never

interface Settings<Value> {
  /** Replaces `undefined`. Without a default, the value is required. */
  default?: Value | undefined
  /** Says what to write instead of a wrong value. */
  advice?: (value: unknown) => string | undefined
}

/** Makes a kind that returns the accepted values unchanged. `expected` is their name in messages. */
export const kind = <Value, Given = Value>(
  expected: string,
  accepts: (value: unknown) => boolean,
  { default: defaultValue, advice }: Settings<Value> = {},
): Kind<Value, Given> => ({
  read(value, place) {
    if (value === undefined && defaultValue !== undefined) return defaultValue
    if (accepts(value)) return value as Value
    throw place.expected(expected, describe(value), advice?.(value))
  },
})

/** Makes an optional kind: a missing value is read as `undefined`. */
export const optional = <Value, Given>({
  read,
}: Kind<Value, Given>): Kind<Value | undefined, Given> => ({
  read: (value, place) => (value === undefined ? undefined : read(value, place)),
})

/** Makes a kind that accepts any value; the caller checks it. */
export const anything = <Value>(): Kind<Value | undefined, Value> => ({
  read: (value) => value as Value | undefined,
})

export const boolean = (defaultValue?: boolean) =>
  kind<boolean>('true or false', (value) => typeof value === 'boolean', { default: defaultValue })

export const oneOf = <const Choice extends string>(
  choices: readonly Choice[],
  defaultChoice?: NoInfer<Choice>,
) =>
  kind<Choice>(listOf(choices), (value) => choices.includes(value as Choice), {
    default: defaultChoice,
  })

/** Lists up to three choices as `'offset' or 'position'`, and more as `one of a, b, c, d`. */
const listOf = (choices: readonly string[]) =>
  choices.length > 3
    ? `one of ${choices.join(', ')}`
    : choices
        .map((choice) => `'${choice}'`)
        .join(', ')
        .replace(/, (?=[^,]*$)/, ' or ')

/** Makes a kind of strings. `expected` is their name in messages, such as `the name of a function`. */
export const text = (expected = 'a text', pattern = /(?:)/, settings: Settings<string> = {}) =>
  kind<string>(expected, (value) => typeof value === 'string' && pattern.test(value), settings)

interface Range {
  min?: number
  max?: number
  /** The name of the maximum in messages. Default: the number. */
  maxName?: string
  default?: number
}

const isInRange = (value: unknown, min: number, max: number) =>
  typeof value === 'number' && value >= min && value <= max

export const wholeNumber = ({ min = 0, max = Infinity, maxName, default: defaultValue }: Range) =>
  kind<number>(
    `a whole number ${max === Infinity ? `of at least ${min}` : `from ${min} to ${maxName ?? max}`}`,
    (value) => Number.isInteger(value) && isInRange(value, min, max),
    { default: defaultValue },
  )

/** Makes a kind of numbers above 0. Infinity is accepted if `max` is infinite. */
export const positiveNumber = ({ max = Number.MAX_VALUE, default: defaultValue }: Range = {}) =>
  kind<number>('a number above 0', (value) => value !== 0 && isInRange(value, 0, max), {
    default: defaultValue,
  })

/** Makes a kind of functions. `expected` is their name in messages, such as `a function from a URI to bytes`. */
export const callable = <F extends Function>(expected = 'a function', settings: Settings<F> = {}) =>
  kind<F>(expected, isCallable, settings)

/** The kind of the function that `compile`, `compileWarp` and the like require. */
export const callback = callable('a function', {
  advice: (value) =>
    typeof value === 'string' && value.includes('{')
      ? 'to pass source in GLSL, convert it to a function by glslOffset(text) of warpjet/glsl'
      : undefined,
})

/** Makes a kind of objects that are not arrays. `expected` is their name in messages. */
export const record = <Value extends object>(expected: string, settings: Settings<Value> = {}) =>
  kind<Value>(
    expected,
    (value) => typeof value === 'object' && value !== null && !isList(value),
    settings,
  )
