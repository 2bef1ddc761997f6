// Messages for operators on expressions in a function that could not be translated, and notes that are printed once.
import { WarpError } from '../errors/errors.js'
import type { Place } from '../options/place.js'

/** Messages that an operator on an expression, or a function of numbers, brings about. */
export const isOfOperator = (error: unknown): error is Error =>
  error instanceof Error &&
  error.name === 'WarpError' &&
  /^JavaScript's own|works on numbers, not on expressions/.test(error.message)

/** Calls a function as it is; where an operator meets an expression in it, `refuse` gives the message. */
export function sayingSo<F extends Function>(f: F, refuse: () => string): F {
  const result = function (this: unknown, ...x: unknown[]): unknown {
    try {
      return new.target ? Reflect.construct(f, x, new.target) : Reflect.apply(f, this, x)
    } catch (error) {
      throw isOfOperator(error) ? new WarpError(refuse()) : error
    }
  }
  return result as unknown as F
}

/** A helper function that is called with expressions; without `refuse` there is nothing to translate in it. */
export const inHelper = (helper: Function, refuse: (() => string) | undefined): Function =>
  refuse ? sayingSo(helper, refuse) : helper

const listNames = (names: readonly string[]) =>
  names.length > 1 ? `it and ${names.slice(1).join(', ')}` : 'it'

export interface Missing {
  /** The call that the function is for. */
  place: Place
  /** Names of variables, and `this`, `super`, `#private` and their like. */
  names: readonly string[]
  /** The names among them that are also names of globals. */
  shadowed: ReadonlySet<string>
  /** The properties of `this` that are read. */
  members: readonly string[]
  /** The name of a helper function; nothing for the offset function itself. */
  helper?: string
}

/** That a method reads a property of `this` and has no object. */
export const lacksThis = (member: string) =>
  `the function reads this.${member}, but a method that is passed by itself has no "this"; write (inputs) => object.method(inputs), or take ${member} from a variable.`

/** That the text of a function cannot see what is around it, and what to write. */
export function cannotSee({ place, names, shadowed, members, helper }: Missing): string {
  const text = helper
    ? `operators are read from the text of the function ${helper}, which it calls`
    : "operators are read from the function's text"
  const [name] = names
  if (name === 'this') {
    const values = members.map((member) => `${member}: this.${member}`)
    return `${place}: ${text}, which cannot see "this" of the object around it; ${
      members.length
        ? `write ${members.join(', ')} in place of ${members.map((member) => `this.${member}`).join(', ')}, and ${remedy(place, values)}`
        : 'write a plain function, and hand it what it needs'
    }.`
  }
  if (!/^[\p{ID_Start}$_]/u.test(name!) || /^(super|new\.target|arguments)$/.test(name!))
    return `${place}: ${text}, which cannot see "${name}" of what is around it; write a plain function that takes it as an argument.`
  const isShadowed = names.some((each) => shadowed.has(each))
  return `${place}: ${text}, which cannot see "${name}" of the sketch around it${
    isShadowed ? ', where it is no global' : ''
  }; ${isShadowed ? '' : `make ${listNames(names)} global, or `}${remedy(place, names)}.`
}

const remedy = ({ method }: Place, values: readonly string[]) =>
  method === 'createWarp'
    ? `add the option { scope: { ${values.join(', ')} } }`
    : `write operators(offset, { ${values.join(', ')} }) with operators of warpjet/operators`

const noted = new Set<string>()

/** Prints a note once. */
export function noteOnce(text: string) {
  if (noted.has(text)) return
  noted.add(text)
  console.warn(text)
}

/** That a variable which changes is read once. */
export const noteReadOnce = (place: Place, name: string) => {
  const label = name.replace(/^.*\./, '')
  noteOnce(
    `${place}: the offset function reads ${name} once, when the warp is made, so the warp does not follow it; write uniforms.${label} in its place, with the option { uniforms: { ${label}: () => ${name} } }.`,
  )
}
