// Handles calls in translated code: of known functions, and of the sketch's own, which are translated like the offset function.
import { isClass, isExpression } from '../errors/describe.js'
import { WarpError } from '../errors/errors.js'
import { guardedKey, isOwnFunction } from '../errors/operators.js'
import { callOnExpressions, callOnNumbers, isKnown } from './functions.js'
import { isOfOperator, wrapHelper } from './messages.js'
import { holdsExpression, isSketch, isWarped, p5Prototype, wholeOf, type Glsl } from './values.js'

export type Translated = (...x: never[]) => unknown

type Any = (...x: unknown[]) => unknown

/** Returns the page's own function, without a guard that the p5 adapter put around it. */
const removeGuard = (f: Any) => (Reflect.get(f, guardedKey) as Any | undefined) ?? f

const isNative = (f: Any) =>
  /\{\s*\[native code\]\s*\}\s*$/.test(Function.prototype.toString.call(f))

/** Returns the name of a function of Math or p5, which a variable may hold, as after `const { sin } = Math`. */
function knownName(f: Any): string | undefined {
  const own = removeGuard(f)
  const name = own.name.replace(/^bound /, '')
  return isNative(own) && isKnown(name) ? name : undefined
}

/** Returns whether a function belongs to the sketch, and neither to JavaScript nor to p5. `host` is the object that has p5's functions. */
function isOwn(name: string, f: Any, host: object = p5Prototype()): boolean {
  const own = removeGuard(f)
  return !isNative(own) && own !== Reflect.get(host, name)
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

/** `make` returns the translated function with the operators of runtime.ts; `explain` returns a message that says why there is none. */
export type Read = { make(operators: object): Translated } | { explain: () => string }

/** Reads a helper function of the sketch, which is called with expressions. */
export type ReadHelper = (helper: Function, name: string) => Read | undefined

export function callsOf(
  glsl: Glsl,
  makeWith: (make: (operators: object) => Translated) => Translated,
  read?: ReadHelper,
) {
  const made = new Map<Function, Function>()

  /** Translates a function or class of the sketch. */
  function translateHelper(helper: Function, name: string): Function {
    let result = made.get(helper)
    if (!result) {
      const reading = read?.(helper, helper.name || name)
      result =
        reading && 'make' in reading
          ? makeWith((operators) => reading.make(operators))
          : wrapHelper(helper, reading && reading.explain)
      if (isBaseClass(helper) && result !== helper)
        Object.setPrototypeOf(result.prototype, helper.prototype as object)
      made.set(helper, result)
      // The translated function may be called again; it needs no translation.
      made.set(result, result)
    }
    return result
  }

  const needsReading = (f: Any, self: unknown, x: unknown[]) =>
    !isExpression(f) &&
    !isOwnFunction(f) &&
    !isNative(f) &&
    self !== glsl &&
    !isExpression(self) &&
    (x.some((each) => holdsExpression(each)) || holdsExpression(self, 1))

  function invokeBy(name: string, f: Any, self: unknown, x: unknown[]): unknown {
    if (needsReading(f, self, x)) return Reflect.apply(translateHelper(f, name), self, x)
    const alias = knownName(f)
    if (alias && x.some(isWarped)) return callKnown(alias, f, x)
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
    if (name in p5Prototype() && !takesAnything.has(name) && x.some(isWarped))
      throw new WarpError(`p5's ${name} works on numbers, not on expressions of a warp.`)
  }

  const callKnown = (name: string, page: Any | undefined, x: unknown[]) =>
    x.some(isWarped) ? callOnExpressions(glsl, name, x, page) : callOnNumbers(glsl, name, x, page)

  /** Calls a function by a bare name, of `Math` or of a p5 sketch. `get` reads the page's own function, which may be missing. */
  function call(name: string, get: () => unknown, ...x: unknown[]): unknown {
    const found = valueOf(get)
    const page = typeof found === 'function' ? (found as Any) : undefined
    if (page && isOwn(name, page)) return invokeBy(name, removeGuard(page), undefined, x)
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
      !isOwn(key, callable(f, key), Object.getPrototypeOf(object) as object)
    ) {
      if (isKnown(key)) return callKnown(key, (f as Any).bind(object), x)
      rejectP5Function(key, x)
    }
    if (isVectorClass(object) && x.some(isWarped)) return ofVectors(key, x)
    return invokeBy(key, callable(f, key), object, x)
  }

  function ofVectors(key: string, x: unknown[]): unknown {
    const name = Object.hasOwn(vectorFunctions, key) && vectorFunctions[key]
    if (name) return glsl[name]!(...x.map((each) => wholeOf(glsl, each)))
    throw new WarpError(`p5.Vector.${key} works on numbers, not on expressions of a warp.`)
  }

  /** `new Class(...x)` */
  const construct = (Class: Any, ...x: unknown[]): unknown =>
    Reflect.construct(
      needsReading(Class, undefined, x) ? translateHelper(Class, Class.name) : Class,
      x,
    )

  return { call, method, invoke, construct }
}

/** Returns whether a class extends no other, so that instances of its translation can be made instances of it. */
const isBaseClass = (f: Function): boolean =>
  isClass(f) && Object.getPrototypeOf(f) === Function.prototype

/** Returns `undefined` if the name does not exist. */
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
