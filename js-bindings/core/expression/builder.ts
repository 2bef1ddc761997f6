// `glsl`, as a sketch gets it: makes inputs and constants, and has every operation as a function. Operations are also
// methods of expressions.
import type { Session } from './session.js'
import { getCore } from '../../wasm/core.js'
import { WarpError, describe } from '../../errors/errors.js'
import { frontEndKey } from '../../errors/front-end.js'
import { Expression, toExpression } from './expression.js'
import { gatherNumbers } from './by-component.js'
import { declareFunction } from './host-functions.js'
import { callNoise, noiseKinds } from './noise.js'
import { repeat } from './repeat.js'
import type { Shape } from './shapes.js'
import { callTexture } from './texture.js'
import { isVec2, partsOf, rotated } from './vector-methods.js'
import { madeOf, meantByFunctions, meantByMethods, methodsOf, sameAs } from './aliases.js'
import { lazyObject } from '../lazy-object.js'
import { didYouMean, refusing } from '../../errors/nearest.js'

export type Builder = Record<string, (...operands: unknown[]) => Expression>

interface Operation {
  name: string
  /** In the wasm. */
  number: number
  /** Vectors and matrices are made by functions only. */
  isMethod: boolean
  /** What only shader text calls is in no list. */
  isListed: boolean
}

let operations: Operation[] | undefined

/** The names are in the wasm, which so starts with the first warp. */
function getOperations(): Operation[] {
  return (operations ??= getCore()
    .operationNames()
    .split(' ')
    .map((name, number) => ({
      name: name.replace(/[+-]/, ''),
      number,
      isMethod: !/[+-]/.test(name),
      isListed: name[0] !== '-',
    })))
}

/** The number of the operation of that name. */
export const operationNumber = (name: string): number =>
  getOperations().find((operation) => operation.name === name)!.number

const gather = (session: Session, name: string, operands: Expression[]) =>
  gatherNumbers(session, name, operands, (numbers) => {
    const constructor = `vec${numbers.length}`
    return session.call(operationNumber(constructor), constructor, numbers)
  })

const params: Record<string, Shape> = {
  param: [1, 1],
  vec2Param: [1, 2],
  vec3Param: [1, 3],
  vec4Param: [1, 4],
  mat2Param: [2, 2],
  mat3Param: [3, 3],
  mat4Param: [4, 4],
}

function frontEnd(): (builder: Builder, ...given: unknown[]) => unknown {
  const read = Reflect.get(globalThis, frontEndKey) as ReturnType<typeof frontEnd> | undefined
  if (read) return read
  throw new WarpError("source: import 'warpjet/glsl' first, which reads shader text.")
}

/** Makes each function of `glsl` for a session. */
const makers = new Map<string, (session: Session, glsl: Builder) => unknown>()
/** Maps name → whether lists have it; functions that only shader text calls are in none. */
const listed = new Map<string, boolean>()

/** Functions that need no `this`, so that `const { vec3, sin } = glsl` works. */
export function createBuilder(session: Session): Builder {
  install()
  const refuse = (name: string) =>
    `glsl.${name}: there is no such function; ${didYouMean(name, Object.keys(glsl), lists, meantByFunctions)}`
  const glsl = lazyObject(refusing(refuse), {
    names: listed,
    make: (name) => makers.get(name)!(session, glsl),
  }) as Builder
  return glsl
}

function installMakers() {
  const add = (
    name: string,
    make: (session: Session, glsl: Builder) => unknown,
    isListed = true,
  ) => {
    makers.set(name, make)
    listed.set(name, isListed)
  }
  add('val', (session) => (value: unknown, ...others: unknown[]) => {
    expectNoMore('val', others)
    return toExpression(session, 'val', value, 1)
  })
  add(
    'texture',
    (session) =>
      (...operands: unknown[]) =>
        callTexture(session, operands),
  )
  add(
    'repeat',
    (session) =>
      (...given: unknown[]) =>
        repeat(session, given),
  )
  add('fn', (session) => (options: unknown) => declareFunction(session, options))
  add(
    'source',
    (_, glsl) =>
      (...given: unknown[]) =>
        frontEnd()(glsl, ...given),
  )
  for (const [name, shape] of Object.entries(params))
    add(name, (session) => (label: unknown, ...others: unknown[]) => {
      if (others.length > 0)
        throw new WarpError(
          `${name}: it takes only a name; there are ${Object.keys(params).join(', ')}.`,
        )
      return session.input(label, shape, name)
    })
  // For front ends, which record functions in sessions of their own: no list has it.
  add('of', () => createBuilder, false)
  for (const { name, number, isListed } of getOperations())
    add(
      name,
      (session) =>
        (...given: unknown[]) => {
          const operands = given.map((operand, i) => toExpression(session, name, operand, i + 1))
          return session.call(number, name, gather(session, name, operands))
        },
      isListed,
    )
  for (const kind of noiseKinds)
    add(
      kind,
      (session) =>
        (...operands: unknown[]) =>
          callNoise(session, kind, operands),
    )
  for (const [alias, name] of Object.entries(sameAs)) add(alias, (_, glsl) => glsl[name])
  for (const [alias, make] of Object.entries(madeOf))
    add(
      alias,
      (session) =>
        (operand: unknown, ...others: unknown[]) =>
          make(methodsOf(toExpression(session, alias, operand, 1)), ...others),
    )
}

/** Only a session makes expressions. */
const sessionOf = (expression: Expression) => expression.session as Session

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
    const by = toExpression(session, 'outputDeriv', input, 2)
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

/**
 * What every expression inherits. It begins as an object without a prototype, which is a mere dictionary to an engine: a
 * thousand swizzles take a twentieth of what they take where `Expression.prototype` gets them one by one.
 */
const methods = Object.create(null) as object

let installed = false

function install() {
  if (installed) return
  installed = true
  installMakers()
  installMethods()
}

function installMethods() {
  for (const [name, indices] of swizzles()) defineComponents(name, indices)
  for (const { name, number, isMethod } of getOperations())
    if (isMethod) defineOperation(name, number)
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
  Object.setPrototypeOf(methods, refusing(unknownMethod))
  Object.setPrototypeOf(Expression.prototype, methods)
}

function expectNoMore(name: string, others: readonly unknown[]) {
  if (others.length > 0)
    throw new WarpError(`${name}: it takes fewer arguments; ${describe(others[0])} is too many.`)
}

const lists = 'web/docs/operations.md lists them all.'

/** Swizzles are not offered: any two letters are near to one. */
function unknownMethod(name: string) {
  const names = Object.getOwnPropertyNames(methods).filter(
    (each) => !/^([xyzwrgba]{1,4}|[stpquv]{1,4})$/.test(each),
  )
  return `${name}: an expression has no such method; ${didYouMean(name, [...names, 'x', 'y', 'z', 'w'], lists, meantByMethods)}`
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

/**
 * An expression that gives itself when it is called. A console prints the source of a function, which so begins with what it is:
 * as the name of a property, since minifiers keep those.
 */
export function callable(name: string, expression: Expression): Expression {
  const [component] = Object.values({
    'an expression of warpjet'(...others: unknown[]) {
      expectNoMore(name, others)
      return expression
    },
  })
  // They are methods of expressions.
  Reflect.deleteProperty(component!, 'length')
  Reflect.deleteProperty(component!, 'name')
  Object.setPrototypeOf(component, Expression.prototype)
  return Object.assign(component!, expression) as unknown as Expression
}

function defineOperation(name: string, number: number) {
  const isTurn = /^rotate[XYZ]$/.test(name)
  define(name, function (...given) {
    const session = sessionOf(this)
    if (name === 'rotate' && isVec2(this)) return rotated(this, ...given)
    if (isTurn && given.length > 0)
      throw new WarpError(
        `${name}: a turn is a matrix, and gives where a vertex goes; write glsl.${name}(angle).mult(v).sub(v).`,
      )
    const operands: Expression[] = [this]
    for (const operand of given)
      operands.push(toExpression(session, name, operand, operands.length))
    return session.call(number, name, gather(session, name, operands), true)
  })
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
