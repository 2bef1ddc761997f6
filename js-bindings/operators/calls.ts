// Handles calls in translated code: calls of known functions, and of the sketch's functions, which are translated like the offset function.
import { isClass, isExpression } from '../errors/describe.js'
import { WarpError } from '../errors/errors.js'
import { guardedKey, isLibraryFunction } from '../errors/operators.js'
import { callOnExpressions, callOnNumbers, isKnown } from './functions.js'
import { isOfOperator, wrapHelper } from './messages.js'
import {
  holdsExpression,
  isExpressionLike,
  isSketch,
  p5Prototype,
  toVector,
  type Glsl,
} from './values.js'

export type Translated = (...x: never[]) => unknown

type Any = (...x: unknown[]) => unknown

/** Returns the page's own function, without a guard that the p5 adapter put around it. */
const removeGuard = (f: Any) => (Reflect.get(f, guardedKey) as Any | undefined) ?? f

const isNative = (f: Any) =>
  /\{\s*\[native code\]\s*\}\s*$/.test(Function.prototype.toString.call(f))

/** Returns the name of a function of Math or p5, which a variable may hold, as after `const { sin } = Math`. */
function knownName(f: Any): string | undefined {
  const unguarded = removeGuard(f)
  const name = unguarded.name.replace(/^bound /, '')
  return isNative(unguarded) && isKnown(name) ? name : undefined
}

/** Returns whether a function belongs to the sketch, and neither to JavaScript nor to p5. `host` is the object that has p5's functions. */
function belongsToSketch(name: string, f: Any, host: object = p5Prototype()): boolean {
  const unguarded = removeGuard(f)
  return !isNative(unguarded) && unguarded !== Reflect.get(host, name)
}

/** Recognizes the class p5.Vector by its shape, since p5 may be a module. */
const isVectorClass = (object: unknown): boolean =>
  typeof object === 'function' && 'random3D' in object && 'fromAngle' in object

/** Maps static functions of p5.Vector to functions of `glsl`. */
const vectorFunctions: Record<string, string> = {
  ...Object.fromEntries(
    'add sub mult div dot cross dist normalize'.split(' ').map((name) => [name, name]),
  ),
  lerp: 'mix',
  mag: 'length',
}

/** Functions of p5 that accept any value. */
const takesAnything = new Set(['print', 'createWarp', 'describe'])

/**
 * `make` returns the translated function, which uses the given operators of runtime.ts; `explain` returns a message that says why the
 * function cannot be translated.
 */
export type TranslationResult = { make(operators: object): Translated } | { explain: () => string }

/** Translates a helper function of the sketch, which is called with expressions; `undefined` if it has nothing to translate. */
export type ReadHelper = (helper: Function, name: string) => TranslationResult | undefined

/** Returns the operators that call functions. `supplyOperators` calls `make` with the operators of the running offset function. */
export function callsOf(
  glsl: Glsl,
  supplyOperators: (make: (operators: object) => Translated) => Translated,
  readHelper?: ReadHelper,
) {
  const translatedHelpers = new Map<Function, Function>()

  /** Translates a function or class of the sketch. */
  function translateHelper(helper: Function, name: string): Function {
    let result = translatedHelpers.get(helper)
    if (!result) {
      const translation = readHelper?.(helper, helper.name || name)
      result =
        translation && 'make' in translation
          ? supplyOperators((operators) => translation.make(operators))
          : wrapHelper(helper, translation && translation.explain)
      if (isBaseClass(helper) && result !== helper)
        Object.setPrototypeOf(result.prototype, helper.prototype as object)
      translatedHelpers.set(helper, result)
      // If the translated function itself is called, it needs no translation.
      translatedHelpers.set(result, result)
    }
    return result
  }

  const needsTranslation = (f: Any, self: unknown, x: unknown[]) =>
    !isExpression(f) &&
    !isLibraryFunction(f) &&
    !isNative(f) &&
    self !== glsl &&
    !isExpression(self) &&
    (x.some((each) => holdsExpression(each)) || holdsExpression(self, 1))

  /** Calls a function; `name` is for messages if the function has none. */
  function invokeBy(name: string, f: Any, self: unknown, x: unknown[]): unknown {
    if (needsTranslation(f, self, x)) return Reflect.apply(translateHelper(f, name), self, x)
    const alias = knownName(f)
    if (alias && x.some(isExpressionLike)) return callKnown(alias, f, x)
    try {
      return Reflect.apply(f, self, x)
    } catch (error) {
      // The function uses an expression that is not an argument, such as a variable of the sketch.
      const translated = isOfOperator(error) && !isNative(f) ? translateHelper(f, name) : f
      if (translated === f) throw error
      return Reflect.apply(translated, self, x)
    }
  }

  /** Calls a function that is the value of a variable. */
  const invoke = (f: Any, self: unknown, ...x: unknown[]) => invokeBy('', f, self, x)

  function rejectP5Function(name: string, x: unknown[]) {
    if (name in p5Prototype() && !takesAnything.has(name) && x.some(isExpressionLike))
      throw new WarpError(`p5's ${name} works on numbers, not on expressions of a warp.`)
  }

  const callKnown = (name: string, page: Any | undefined, x: unknown[]) =>
    x.some(isExpressionLike)
      ? callOnExpressions(glsl, name, x, page)
      : callOnNumbers(glsl, name, x, page)

  /**
   * Calls a function by name: a function of `Math`, or one that a sketch calls without an object. `get` reads the page's function, which
   * may be missing.
   */
  function call(name: string, get: () => unknown, ...x: unknown[]): unknown {
    const found = valueOf(get)
    const page = typeof found === 'function' ? (found as Any) : undefined
    if (page && belongsToSketch(name, page)) return invokeBy(name, removeGuard(page), undefined, x)
    if (isKnown(name)) return callKnown(name, page, x)
    if (page) rejectP5Function(name, x)
    return (get() as Any)(...x)
  }

  /** `object[key](...x)` */
  function method(object: unknown, key: string, ...x: unknown[]): unknown {
    if (object === Math && isKnown(key)) return call(key, () => Reflect.get(Math, key), ...x)
    const f = (object as Record<string, unknown>)[key]
    if (isExpression(object)) return Reflect.apply(callable(f, key), object, x)
    if (
      isSketch(object) &&
      !belongsToSketch(key, callable(f, key), Object.getPrototypeOf(object) as object)
    ) {
      if (isKnown(key)) return callKnown(key, (f as Any).bind(object), x)
      rejectP5Function(key, x)
    }
    if (isVectorClass(object) && x.some(isExpressionLike)) return callVectorFunction(key, x)
    return invokeBy(key, callable(f, key), object, x)
  }

  function callVectorFunction(key: string, x: unknown[]): unknown {
    const name = Object.hasOwn(vectorFunctions, key) && vectorFunctions[key]
    if (name) return glsl[name]!(...x.map((each) => toVector(glsl, each)))
    throw new WarpError(`p5.Vector.${key} works on numbers, not on expressions of a warp.`)
  }

  /** `new Class(...x)` */
  const construct = (Class: Any, ...x: unknown[]): unknown =>
    Reflect.construct(
      needsTranslation(Class, undefined, x) ? translateHelper(Class, Class.name) : Class,
      x,
    )

  return { call, method, invoke, construct }
}

/**
 * Returns whether a class has no superclass. Only then can the prototype of its translation inherit from its own, so that `instanceof`
 * works.
 */
const isBaseClass = (f: Function): boolean =>
  isClass(f) && Object.getPrototypeOf(f) === Function.prototype

/** Returns the value of a variable that `get` reads; `undefined` if the variable does not exist. */
function valueOf(get: () => unknown): unknown {
  try {
    return get()
  } catch (error) {
    if (error instanceof ReferenceError) return undefined
    throw error
  }
}

function callable(f: unknown, key: string): Any {
  if (typeof f !== 'function') throw new TypeError(`${key} is not a function`)
  return f as Any
}
