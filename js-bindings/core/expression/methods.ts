// The methods of expressions: components, operations, noises, and what p5.Vector and glsl-autodiff have.
import { describe } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import { didYouMean, refusing } from '../../errors/nearest.js'
import { Place } from '../../options/place.js'
import { madeOf, meantByMethods, methodsOf, operationLists, sameAs } from './aliases.js'
import { gatherNumbers } from './by-component.js'
import { Expression, toExpression } from './expression.js'
import { callNoise, noiseKinds } from './noise.js'
import { type Operation, getOperations, operationNamed } from './operations.js'
import type { Session } from './session.js'
import { isVec2, partsOf, rotated } from './vector-methods.js'

/**
 * What every expression inherits. It begins as an object without a prototype, which is a mere dictionary to an engine, since
 * `Expression.prototype` takes far longer to get hundreds of properties one by one.
 */
const methods = Object.create(null) as object

/** Only a session makes expressions. */
const sessionOf = (expression: Expression) => expression.session as Session

export function installMethods() {
  for (const letter of alphabets.join('')) defineSwizzle(letter)
  for (const operation of getOperations().values())
    if (operation.isMethod) defineOperation(operation)
  for (const kind of noiseKinds)
    define(kind, function (...operands) {
      return callNoise(sessionOf(this), kind, [this, ...operands], true)
    })
  for (const [name, method] of Object.entries(others)) define(name, method)
  for (const [alias, name] of Object.entries(sameAs))
    if (Object.hasOwn(methods, name))
      define(alias, function (...operands) {
        return methodsOf(this)[name]!(...operands)
      })
  for (const [alias, make] of Object.entries(madeOf))
    define(alias, function (...others) {
      return make(methodsOf(this), ...others)
    })
  Object.setPrototypeOf(methods, new Proxy(refusing(unknownMethod), lazySwizzles))
  Object.setPrototypeOf(Expression.prototype, methods)
}

/** Swizzles are not offered: any two letters are near to one. */
function unknownMethod(name: string) {
  const names = Object.getOwnPropertyNames(methods).filter((each) => !indicesOf(each))
  return `${name}: an expression has no such method; ${didYouMean(name, [...names, 'x', 'y', 'z', 'w'], operationLists, meantByMethods)}`
}

type Method = (this: Expression, ...operands: unknown[]) => unknown

function define(name: string, method: Method) {
  const value = function (this: unknown, ...operands: unknown[]) {
    if (!(this instanceof Expression)) throw uncalled(name)
    const result = method.apply(this, operands)
    sessionOf(this).followCopy(this, name, result)
    return result
  }
  Object.defineProperty(methods, name, { value, configurable: true, writable: true })
}

const uncalled = (name: string) =>
  new WarpError(`${name}: call it on an expression, as in x.${name}(…).`)

function defineOperation(operation: Operation) {
  const { name, place } = operation
  const isTurn = /^rotate[XYZ]$/.test(name)
  define(name, function (...given) {
    const session = sessionOf(this)
    if (name === 'rotate' && isVec2(this)) return rotated(this, ...given)
    if (isTurn && given.length > 0)
      throw place.error(
        `a turn is a matrix, and gives where a vertex goes; write glsl.${name}(angle).mult(v).sub(v).`,
      )
    const operands: Expression[] = [this]
    for (const operand of given)
      operands.push(toExpression(session, operand, place, operands.length))
    return session.call(operation, gatherNumbers(session, name, operands), true)
  })
}

const outputDeriv = new Place('outputDeriv')

/** Methods that give no expression: the numbers of a vector as p5 has them, and those that ask for results, as glsl-autodiff does. */
const others = {
  array(this: Expression) {
    return partsOf(this)
  },
  output(this: Expression, name: unknown) {
    sessionOf(this).ask(name, this, 'output')
  },
  outputDeriv(this: Expression, name: unknown, input: unknown) {
    const session = sessionOf(this)
    const by = toExpression(session, input, outputDeriv, 2)
    session.ask(name, session.call(operationNamed('derivative'), [this, by]), 'outputDeriv')
  },
}

/** The letters of components: as coordinates, as colors and as texture coordinates. */
const alphabets = ['xyzw', 'rgba', 'stpq', 'uv']

/** The indices of the components that a swizzle selects, as of `zyx` or `rg`; `undefined` for another name. */
function indicesOf(name: string): number[] | undefined {
  const letters = [...name]
  const alphabet = alphabets.find((each) => letters.every((letter) => each.includes(letter)))
  return alphabet && letters.length <= 4
    ? letters.map((letter) => alphabet.indexOf(letter))
    : undefined
}

/** Defines a swizzle: `v.y` is the component, and so is `v.y()`. Returns whether the name is that of a swizzle. */
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
 * The end of the prototype chain. There are 1,050 swizzles, of which a warp reads a few: each longer one is defined when
 * it is first looked up, which takes 3 ms from the first warp of a page.
 */
const lazySwizzles: ProxyHandler<object> = {
  get: (target, name, receiver) =>
    Reflect.get(defineSwizzle(name) ? methods : target, name, receiver) as unknown,
  set: (target, name, value, receiver) =>
    Reflect.set(defineSwizzle(name) ? methods : target, name, value, receiver),
  has: (target, name) => defineSwizzle(name) || Reflect.has(target, name),
}

export function rejectMore(name: string, others: readonly unknown[]) {
  if (others.length > 0)
    throw new WarpError(`${name}: it takes fewer arguments; ${describe(others[0])} is too many.`)
}

/**
 * An expression that gives itself when it is called. A console prints the source of a function, which so begins with what it is:
 * as the name of a property, since minifiers keep those.
 */
export function callable(name: string, expression: Expression): Expression {
  const [component] = Object.values({
    'an expression of warpjet'(...others: unknown[]) {
      rejectMore(name, others)
      return expression
    },
  })
  // They are methods of expressions.
  Reflect.deleteProperty(component!, 'length')
  Reflect.deleteProperty(component!, 'name')
  Object.setPrototypeOf(component, Expression.prototype)
  return Object.assign(component!, expression) as unknown as Expression
}
