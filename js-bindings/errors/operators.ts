/** The global under which 'warpjet/operators' registers itself, so that every copy of warpjet on a page finds it. */
export const operatorsKey = Symbol.for('warpjet.operators')

/** The property by which a guard of p5's adapter refers to the function that it wraps. */
export const guardedKey = Symbol.for('warpjet.guarded')

const libraryFunctionKey = Symbol.for('warpjet.own')

/** Marks a function of the library, whose source must not be translated. Returns the function. */
export const markLibraryFunction = <F extends object>(f: F): F =>
  Object.defineProperty(f, libraryFunctionKey, { value: true })

export const isLibraryFunction = (f: object): boolean => libraryFunctionKey in f

/** Options for translating operators. */
export interface TranslationOptions {
  /** The name of the called function in messages. */
  method?: string
  /** Maps the name of a variable → its value. */
  scope?: Readonly<Record<string, unknown>> | undefined
  /** The p5 sketch that the function belongs to. */
  sketch?: object | undefined
}

type Translate = <F extends Function>(offset: F, scope?: object, options?: TranslationOptions) => F

/** Returns the function with its operators translated, if the page has 'warpjet/operators'; otherwise the function itself. */
export function translateOperators<F extends Function>(offset: F, options: TranslationOptions): F {
  const translate = Reflect.get(globalThis, operatorsKey) as Translate | undefined
  if (!translate || isLibraryFunction(offset)) return offset
  return translate(offset, options.scope ?? {}, options)
}
