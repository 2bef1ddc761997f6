// The methods of expressions: components, operations, noises, and what p5.Vector and glsl-autodiff have.
import { describe } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import { didYouMean, throwingPrototype } from '../../errors/nearest.js'
import { Place } from '../../options/place.js'
import { madeOf, meantByMethods, methodsOf, operationLists, sameAs } from './aliases.js'
import { gatherNumbers } from './by-component.js'
import { Expression, toExpression } from './expression.js'
import { callNoise, noiseKinds } from './noise.js'
import { type Operation, getOperations, operationNumber } from './operations.js'
import type { Session } from './session.js'
import { isVec2, partsOf, rotated } from './vector-methods.js'

/**
 * What every expression inherits. It begins as an object without a prototype, which is a mere dictionary to an engine: a
 * thousand swizzles take a twentieth of what they take where `Expression.prototype` gets them one by one.
 */
const methods = Object.create(null) as object

/** Only a session makes expressions. */
const sessionOf = (expression: Expression) => expression.session as Session

export function installMethods() {
  for (const [name, indices] of swizzles()) defineComponents(name, indices)
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
  Object.setPrototypeOf(methods, throwingPrototype(unknownMethod))
  Object.setPrototypeOf(Expression.prototype, methods)
}

/** Swizzles are not offered: any two letters are near to one. */
function unknownMethod(name: string) {
  const names = Object.getOwnPropertyNames(methods).filter(
    (each) => !/^([xyzwrgba]{1,4}|[stpquv]{1,4})$/.test(each),
  )
  return `${name}: an expression has no such method; ${didYouMean(name, [...names, 'x', 'y', 'z', 'w'], operationLists, meantByMethods)}`
}

function define(name: string, method: (this: Expression, ...operands: unknown[]) => unknown) {
  const value = function (this: unknown, ...operands: unknown[]) {
    if (this instanceof Expression) {
      const result = method.apply(this, operands)
      sessionOf(this).followCopy(this, name, result)
      return result
    }
    throw new WarpError(`${name}: call it on an expression, as in x.${name}(…).`)
  }
  Object.defineProperty(methods, name, { value, configurable: true, writable: true })
}

function defineOperation({ name, number, place }: Operation) {
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
    return session.call(number, name, gatherNumbers(session, name, operands), true)
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
    session.ask(
      name,
      session.call(operationNumber('derivative'), 'outputDeriv', [this, by]),
      'outputDeriv',
    )
  },
}

/** All selections of components: `x`, `xy`, `zyx`, `rgba`, `st`, `uv`, with their indices. */
function* swizzles(): Generator<[name: string, indices: number[]]> {
  for (const letters of ['xyzw', 'rgba', 'stpq', 'uv']) {
    let names: [string, number[]][] = [['', []]]
    for (let length = 1; length <= 4; length++) {
      names = names.flatMap(([name, indices]) =>
        [...letters].map((letter, i): [string, number[]] => [name + letter, [...indices, i]]),
      )
      yield* names
    }
  }
}

/** `v.y` is the component, and so is `v.y()`. */
function defineComponents(name: string, indices: readonly number[]) {
  Object.defineProperty(methods, name, {
    configurable: true,
    get(this: unknown) {
      if (this instanceof Expression)
        return callable(name, sessionOf(this).swizzle(name, this, indices))
      return () => {
        throw new WarpError(`${name}: call it on an expression, as in v.${name}().`)
      }
    },
    set(this: unknown) {
      throw new WarpError(
        `${name}: a component cannot be changed; make a new vector, as in glsl.vec3(x, y, z).`,
      )
    },
  })
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
