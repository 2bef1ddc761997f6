// Objects of options: which options there are, and the kind of each.
import { describe } from '../errors/errors.js'
import { nearest } from '../errors/nearest.js'
import { isList } from './guards.js'
import type { GivenOf, Kind, ValueOf } from './kinds.js'
import { Place } from './place.js'

/** Maps the name of an option → its kind. */
export type Kinds = Readonly<Record<string, Kind<unknown, any>>>

/** The kinds that options of this type need. `{ … } satisfies KindsOf<Options>` proves that a schema has just these options. */
export type KindsOf<Options> = {
  readonly [Name in keyof Options]-?: Kind<unknown, Exclude<Options[Name], undefined>>
}

/** The options as they are read: defaults stand for what is left out. */
export type ValuesOf<All extends Kinds> = { [Name in keyof All]: ValueOf<All[Name]> }

/** The options as users may give them. */
export type OptionsOf<All extends Kinds> = {
  [Name in keyof All]?: GivenOf<All[Name]>
}

/** An object of options, itself a kind, so that schemas nest. `advice` says what to write in place of an unknown option. */
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
      return Object.fromEntries(
        all.map(([name, kind]) => [name, kind.read(options[name], place.option(name))]),
      ) as ValuesOf<All>
    },
  }
}

/** Throws unless `given` is `undefined` or an object that has only known options. */
export function rejectUnknownOptions(
  given: unknown,
  known: readonly string[],
  at: Place | string,
  advice?: (name: string) => string,
) {
  if (given === undefined) return
  if (typeof given !== 'object' || given === null || isList(given))
    throw expectedObject(Place.of(at), given)
  for (const name in given)
    if (Object.hasOwn(given, name) && !known.includes(name))
      throw unknownOption(
        Place.of(at),
        `"${name}"`,
        (advice ?? ((other) => listWithNearest(other, known)))(name),
      )
}

const expectedObject = (place: Place, given: unknown) =>
  place.expected(place.subject ? 'an object' : 'an object of options', describe(given))

const unknownOption = (place: Place, name: string, advice: string) =>
  place.error(`there is no option ${name}${place.subject && ` in ${place.subject}`}; ${advice}`)

function listWithNearest(name: string, known: readonly string[]) {
  const near = nearest(name, known)
  const list = `here ${known.length > 1 ? 'are' : 'is'} ${known.join(', ')}.`
  return near ? `did you mean ${near}? T${list}` : `t${list}`
}
