/** The global under which 'warpjet/operators' registers itself, so that every copy of warpjet on a page finds it. */
export const operatorsKey = Symbol.for('warpjet.operators')

/** The property by which a guard of p5's adapter names the function that it stands before. */
export const guardedKey = Symbol.for('warpjet.guarded')

const ownKey = Symbol.for('warpjet.own')

/** Marks a function of the library, whose text nobody is to read. */
export const asOwn = <F extends object>(f: F): F =>
  Object.defineProperty(f, ownKey, { value: true })

export const isOwnFunction = (f: object): boolean => ownKey in f

/** Options of a reader of operators. */
export interface ReadOptions {
  /** The name in messages. */
  method?: string
  /** Variables by name. */
  scope?: Readonly<Record<string, unknown>> | undefined
  /** The p5 sketch that the function is for. */
  sketch?: object | undefined
}

type Reader = <F extends Function>(offset: F, scope?: object, options?: ReadOptions) => F

/** The offset function with its operators read, if the page has 'warpjet/operators'; otherwise the function itself. */
export function readOperators<F extends Function>(offset: F, options: ReadOptions): F {
  const read = Reflect.get(globalThis, operatorsKey) as Reader | undefined
  return read && !isOwnFunction(offset) ? read(offset, options.scope ?? {}, options) : offset
}
