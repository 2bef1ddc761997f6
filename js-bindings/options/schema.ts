// Schemas: which options an object may have, and the kind of each.
import { describe } from '../errors/errors.js'
import { nearest } from '../errors/nearest.js'
import { isList } from './guards.js'
import type { InputOf, Kind, ValueOf } from './kinds.js'
import type { Place } from './place.js'

/** Maps the name of an option → its kind. */
export type Kinds = Readonly<Record<string, Kind<unknown, any>>>

/** The schema of a type of options. `{ … } satisfies KindsOf<Options>` proves that a schema has exactly these options. */
export type KindsOf<Options> = {
  readonly [Name in keyof Options]-?: Kind<unknown, Exclude<Options[Name], undefined>>
}

/** The values of the options, with defaults for those that the user left out. */
export type ValuesOf<All extends Kinds> = { [Name in keyof All]: ValueOf<All[Name]> }

/** The options as users write them. */
export type OptionsOf<All extends Kinds> = {
  [Name in keyof All]?: InputOf<All[Name]>
}

export interface Schema<All extends Kinds> extends Kind<ValuesOf<All>, OptionsOf<All>> {
  /** Reads options into an object of the caller. Creates no garbage, unless a kind does. */
  readInto(values: Partial<ValuesOf<All>>, value: unknown, place: Place): void
}

/**
 * Makes the kind of an object of options. A schema is a kind itself, so schemas nest. `advice` says what to write instead of an unknown
 * option.
 */
export const object = <All extends Kinds>(
  kinds: All,
  advice?: (name: string) => string,
): Schema<All> => {
  const names = Object.keys(kinds)
  const readInto = (
    values: Record<string, unknown>,
    value: Readonly<Record<string, unknown>> | undefined,
    place: Place,
  ) => {
    rejectUnknownOptions(value, names, place, advice)
    for (let i = 0; i < names.length; i++) {
      const name = names[i]!
      values[name] = kinds[name]!.read(value?.[name], place.option(name))
    }
  }
  return {
    readInto: readInto as Schema<All>['readInto'],
    read(value, place) {
      const values = {}
      readInto(values, value as never, place)
      return values as ValuesOf<All>
    },
  }
}

/** Throws unless `options` is `undefined` or an object that has only known options. */
export function rejectUnknownOptions(
  options: unknown,
  known: readonly string[],
  place: Place,
  advice?: (name: string) => string,
) {
  if (options === undefined) return
  if (typeof options !== 'object' || options === null || isList(options))
    throw place.expected(place.subject ? 'an object' : 'an object of options', describe(options))
  for (const name in options)
    if (Object.hasOwn(options, name) && !known.includes(name)) {
      const parent = place.subject && ` in ${place.subject}`
      // `advice` has no default value, since that would allocate a function at each call.
      const remedy = advice ? advice(name) : listWithNearest(name, known)
      throw place.error(`there is no option "${name}"${parent}; ${remedy}`)
    }
}

function listWithNearest(name: string, known: readonly string[]) {
  const suggestion = nearest(name, known)
  const list = `the ${known.length > 1 ? 'options are' : 'only option is'} ${known.join(', ')}.`
  if (!suggestion) return list
  return `did you mean ${suggestion}? ${list[0]!.toUpperCase()}${list.slice(1)}`
}
