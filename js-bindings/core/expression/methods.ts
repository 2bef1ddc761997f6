// The methods of expressions: components, operations, noises, and methods of p5.Vector and glsl-autodiff.
import { describe } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import { didYouMean, throwingPrototype } from '../../errors/nearest.js'
import { Place } from '../../options/place.js'
import { aliases, compositions, meantByMethods, methodsOf, operationLists } from './aliases.js'
import { gatherNumbers } from './by-component.js'
import { Expression, toExpression } from './expression.js'
import { callNoise, noiseKinds } from './noise.js'
import { getOperations, operationNamed, type Operation } from './operations.js'
import type { Session } from './session.js'
import { componentsOf, isVec2, rotateVec2 } from './vector-methods.js'

/**
 * The prototype of `Expression.prototype`. It starts without a prototype, so that engines treat it as a dictionary: adding
 * hundreds of properties to `Expression.prototype` one by one takes far longer.
 */
const methods = Object.create(null) as object

/** Returns the session of an expression. The session is a `Session`, since nothing else makes expressions. */
const sessionOf = (expression: Expression) => expression.session as Session

export function installMethods() {
  for (const letter of alphabets.join('')) defineSwizzle(letter)
  for (const operation of getOperations().values())
    if (operation.isMethod) defineOperation(operation)
  for (const kind of noiseKinds)
    define(kind, function (...operands) {
      return callNoise(sessionOf(this), kind, [this, ...operands], true)
    })
  for (const [name, method] of Object.entries(otherMethods)) define(name, method)
  for (const [alias, name] of Object.entries(aliases))
    if (Object.hasOwn(methods, name))
      define(alias, function (...operands) {
        return methodsOf(this)[name]!(...operands)
      })
  for (const [alias, make] of Object.entries(compositions))
    define(alias, function (...others) {
      return make(methodsOf(this), ...others)
    })
  Object.setPrototypeOf(methods, new Proxy(throwingPrototype(unknownMethod), lazySwizzles))
  Object.setPrototypeOf(Expression.prototype, methods)
}

/** Returns the message about an unknown method. It suggests no swizzles, since any two letters are similar to a swizzle. */
function unknownMethod(name: string) {
  const names = Object.getOwnPropertyNames(methods).filter((each) => !indicesOf(each))
  return `${name}: an expression has no such method; ${didYouMean(name, [...names, 'x', 'y', 'z', 'w'], operationLists, meantByMethods)}`
}

type Method = (this: Expression, ...operands: unknown[]) => unknown

function define(name: string, method: Method) {
  const value = function (this: unknown, ...operands: unknown[]) {
    if (!(this instanceof Expression)) throw notOnExpression(name)
    const result = method.apply(this, operands)
    sessionOf(this).followCopy(this, name, result)
    return result
  }
  Object.defineProperty(methods, name, { value, configurable: true, writable: true })
}

const notOnExpression = (name: string) =>
  new WarpError(`${name}: call it on an expression, as in x.${name}(…).`)

function defineOperation(operation: Operation) {
  const { name, place } = operation
  const isRotation = /^rotate[XYZ]$/.test(name)
  define(name, function (...given) {
    const session = sessionOf(this)
    if (name === 'rotate' && isVec2(this)) return rotateVec2(this, ...given)
    if (isRotation && given.length > 0)
      throw place.error(
        `a rotation is a matrix, and its product with a vertex is the new position, not the offset; write glsl.${name}(angle).mult(v).sub(v).`,
      )
    const operands: Expression[] = [this]
    for (const operand of given)
      operands.push(toExpression(session, operand, place, operands.length))
    return session.call(operation, gatherNumbers(session, name, operands), true)
  })
}

const outputPlace = new Place('output')
const outputDeriv = new Place('outputDeriv')

/** Methods that do not return an expression: `array()` of p5.Vector, and those of glsl-autodiff that request results. */
const otherMethods = {
  array(this: Expression) {
    return componentsOf(this)
  },
  output(this: Expression, name: unknown) {
    sessionOf(this).requestOutput(name, this, outputPlace)
  },
  outputDeriv(this: Expression, name: unknown, input: unknown) {
    const session = sessionOf(this)
    const variable = toExpression(session, input, outputDeriv, 2)
    const derivative = session.call(operationNamed('derivative'), [this, variable])
    session.requestOutput(name, derivative, outputDeriv)
  },
}

/** The letters of components: as coordinates, as colors and as texture coordinates. */
const alphabets = ['xyzw', 'rgba', 'stpq', 'uv']

/** Returns the indices of the components that a swizzle such as `zyx` or `rg` selects; `undefined` for another name. */
function indicesOf(name: string): number[] | undefined {
  const letters = [...name]
  const alphabet = alphabets.find((each) => letters.every((letter) => each.includes(letter)))
  return alphabet && letters.length <= 4
    ? letters.map((letter) => alphabet.indexOf(letter))
    : undefined
}

/** Defines a swizzle: `v.y` and `v.y()` are the component. Returns `false` if the name is not that of a swizzle. */
function defineSwizzle(name: PropertyKey): boolean {
  const indices = typeof name === 'string' && name ? indicesOf(name) : undefined
  if (!indices) return false
  const swizzle = name as string
  Object.defineProperty(methods, swizzle, {
    configurable: true,
    get(this: unknown) {
      if (this instanceof Expression)
        return callable(swizzle, sessionOf(this).swizzle(swizzle, this, indices))
      return () => {
        throw new WarpError(`${swizzle}: call it on an expression, as in v.${swizzle}().`)
      }
    },
    set(this: unknown) {
      throw new WarpError(
        `${swizzle}: a component cannot be changed; make a new vector, as in glsl.vec3(x, y, z).`,
      )
    },
  })
  return true
}

/**
 * The end of the prototype chain. There are 1,050 swizzles, of which a warp reads a few: those of several letters are defined
 * when they are first looked up, so that the first warp of a page does not define them all.
 */
const lazySwizzles: ProxyHandler<object> = {
  get: (target, name, receiver) =>
    Reflect.get(defineSwizzle(name) ? methods : target, name, receiver) as unknown,
  set: (target, name, value, receiver) =>
    Reflect.set(defineSwizzle(name) ? methods : target, name, value, receiver),
  has: (target, name) => defineSwizzle(name) || Reflect.has(target, name),
}

/** Throws if there are further arguments. */
export function rejectMore(name: string, others: readonly unknown[]) {
  if (others.length > 0)
    throw new WarpError(`${name}: it takes fewer arguments; ${describe(others[0])} is too many.`)
}

/**
 * Makes an expression callable: the call returns the expression. A console prints the source of the function, so the function's name
 * describes the expression. It is the name of a property, since minifiers do not change these.
 */
export function callable(name: string, expression: Expression): Expression {
  const [callableExpression] = Object.values({
    'an expression of warpjet'(...others: unknown[]) {
      rejectMore(name, others)
      return expression
    },
  })
  // `length` and `name` would hide methods of expressions.
  Reflect.deleteProperty(callableExpression!, 'length')
  Reflect.deleteProperty(callableExpression!, 'name')
  // Assigned before the prototype is set: the prototype chain ends with a proxy, which would handle each new property.
  Object.assign(callableExpression!, expression)
  return Object.setPrototypeOf(callableExpression, Expression.prototype) as Expression
}
