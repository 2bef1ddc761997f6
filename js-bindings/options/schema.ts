// Schemas: the options of an object, and the kind of each.
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

/** The options after reading, with defaults for those left out. */
export type ValuesOf<All extends Kinds> = { [Name in keyof All]: ValueOf<All[Name]> }

/** The options as users write them. */
export type OptionsOf<All extends Kinds> = {
  [Name in keyof All]?: InputOf<All[Name]>
}

/** Makes the kind of an object of options. A schema is a kind itself, so schemas nest. `advice` says what to write instead of an unknown option. */
export const object = <All extends Kinds>(
  kinds: All,
  advice?: (name: string) => string,
): Kind<ValuesOf<All>, OptionsOf<All>> => {
  const all = Object.entries(kinds)
  const names = Object.keys(kinds)
  return {
    read(given, place) {
      rejectUnknownOptions(given, names, place, advice)
      const options = (given ?? {}) as Record<string, unknown>
      const values: Record<string, unknown> = {}
      for (const [name, kind] of all) values[name] = kind.read(options[name], place.option(name))
      return values as ValuesOf<All>
    },
  }
}

/** Throws unless `given` is `undefined` or an object that has only known options. */
export function rejectUnknownOptions(
  given: unknown,
  known: readonly string[],
  place: Place,
  advice?: (name: string) => string,
) {
  if (given === undefined) return
  if (typeof given !== 'object' || given === null || isList(given))
    throw place.expected(place.subject ? 'an object' : 'an object of options', describe(given))
  for (const name in given)
    if (Object.hasOwn(given, name) && !known.includes(name)) {
      const parent = place.subject && ` in ${place.subject}`
      // Not a default of the parameter: that would allocate a function at each call.
      const remedy = advice ? advice(name) : listWithNearest(name, known)
      throw place.error(`there is no option "${name}"${parent}; ${remedy}`)
    }
}

function listWithNearest(name: string, known: readonly string[]) {
  const near = nearest(name, known)
  const list = `the ${known.length > 1 ? 'options are' : 'only option is'} ${known.join(', ')}.`
  return near ? `did you mean ${near}? ${list[0]!.toUpperCase()}${list.slice(1)}` : list
}
