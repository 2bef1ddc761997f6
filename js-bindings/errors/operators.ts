/** The global under which 'warpjet/operators' registers itself, so that every copy of warpjet on a page finds it. */
export const operatorsKey = Symbol.for('warpjet.operators')

/** The property by which a guard of p5's adapter refers to the function that it wraps. */
export const guardedKey = Symbol.for('warpjet.guarded')

const ownKey = Symbol.for('warpjet.own')

/** Marks a function of the library, whose source must not be translated. */
export const asOwn = <F extends object>(f: F): F =>
  Object.defineProperty(f, ownKey, { value: true })

export const isOwnFunction = (f: object): boolean => ownKey in f

/** Options for translating operators. */
export interface ReadOptions {
  /** The name of the called function in messages. */
  method?: string
  /** Maps the name of a variable → its value. */
  scope?: Readonly<Record<string, unknown>> | undefined
  /** The p5 sketch that the function belongs to. */
  sketch?: object | undefined
}

type Reader = <F extends Function>(offset: F, scope?: object, options?: ReadOptions) => F

/** Returns the function with its operators translated, if the page has 'warpjet/operators'; otherwise the function itself. */
export function readOperators<F extends Function>(offset: F, options: ReadOptions): F {
  const read = Reflect.get(globalThis, operatorsKey) as Reader | undefined
  return read && !isOwnFunction(offset) ? read(offset, options.scope ?? {}, options) : offset
}
