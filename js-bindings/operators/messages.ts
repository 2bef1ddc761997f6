// Messages about operators on expressions in a function that could not be translated, and warnings that are printed once.
import { WarpError } from '../errors/errors.js'
import type { Place } from '../options/place.js'

/** Returns whether the error was thrown by an operator on an expression, or by a function that works only on numbers. */
export const isOfOperator = (error: unknown): error is Error =>
  error instanceof Error &&
  error.name === 'WarpError' &&
  /^JavaScript's own|works on numbers, not on expressions/.test(error.message)

/** Wraps a function such that an error about an operator on an expression gets the message of `explain`. */
export function withOperatorMessage<F extends Function>(f: F, explain: () => string): F {
  const result = function (this: unknown, ...x: unknown[]): unknown {
    try {
      return new.target ? Reflect.construct(f, x, new.target) : Reflect.apply(f, this, x)
    } catch (error) {
      throw isOfOperator(error) ? new WarpError(explain()) : error
    }
  }
  return result as unknown as F
}

/** Wraps a helper function that is called with expressions. If `explain` is missing, the function contains nothing to translate. */
export const wrapHelper = (helper: Function, explain: (() => string) | undefined): Function =>
  explain ? withOperatorMessage(helper, explain) : helper

const listNames = (names: readonly string[]) =>
  names.length > 1 ? `it and ${names.slice(1).join(', ')}` : 'it'

export interface Missing {
  /** The call that the function was passed to. */
  place: Place
  /** Names of variables, and `this`, `super`, `#private` and so on. */
  names: readonly string[]
  /** The subset of `names` that are also names of globals. */
  shadowed: ReadonlySet<string>
  /** The properties of `this` that are read. */
  members: readonly string[]
  /** The name of the helper function; `undefined` for the offset function itself. */
  helper?: string
}

/** Returns the message for a method that reads a property of `this` but was passed without its object. */
export const describeMissingThis = (member: string) =>
  `the function reads this.${member}, but a method that is passed by itself has no "this"; write (inputs) => object.method(inputs), or take ${member} from a variable.`

/** Returns the message for a function whose source refers to variables around it, with advice on what to write. */
export function describeInvisible({ place, names, shadowed, members, helper }: Missing): string {
  const text = helper
    ? `operators are translated in the source code of the function ${helper}, which it calls`
    : "operators are translated in the function's source code"
  const [name] = names
  if (name === 'this') {
    const values = members.map((member) => `${member}: this.${member}`)
    return `${place}: ${text}, which cannot access "this" of the enclosing object; ${
      members.length
        ? `write ${members.join(', ')} in place of ${members.map((member) => `this.${member}`).join(', ')}, and ${remedy(place, values)}`
        : 'write a plain function, and pass the values that it needs'
    }.`
  }
  if (!/^[\p{ID_Start}$_]/u.test(name!) || /^(super|new\.target|arguments)$/.test(name!))
    return `${place}: ${text}, which cannot access "${name}" of the enclosing scope; write a plain function that takes it as an argument.`
  const isShadowed = names.some((each) => shadowed.has(each))
  return `${place}: ${text}, which cannot access "${name}" of the enclosing scope${
    isShadowed ? ', where it is a local variable, not the global one' : ''
  }; ${isShadowed ? '' : `make ${listNames(names)} global, or `}${remedy(place, names)}.`
}

const remedy = ({ method }: Place, values: readonly string[]) =>
  method === 'createWarp'
    ? `add the option { scope: { ${values.join(', ')} } }`
    : `write operators(offset, { ${values.join(', ')} }) with operators of warpjet/operators`

const printed = new Set<string>()

/** Prints each warning only once. */
export function noteOnce(text: string) {
  if (printed.has(text)) return
  printed.add(text)
  console.warn(text)
}

/** Warns that a changing variable is read only once. */
export const noteReadOnce = (place: Place, name: string) => {
  const label = name.replace(/^.*\./, '')
  noteOnce(
    `${place}: the offset function reads ${name} once, when the warp is made, so the warp does not follow it; write uniforms.${label} in its place, with the option { uniforms: { ${label}: () => ${name} } }.`,
  )
}
