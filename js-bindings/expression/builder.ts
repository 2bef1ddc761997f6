// `glsl`, as a sketch gets it: makes inputs and constants, and has every operation as a function. Operations are also
// methods of expressions.
import type { Session } from './session.js'
import { getCore } from '../wasm/core.js'
import { WarpError, describe } from '../checks/errors.js'
import { frontEndKey } from '../checks/front-end.js'
import { Expression, toExpression } from './expression.js'
import { declareFunction } from './host-functions.js'
import { callNoise, noiseKinds } from './noise.js'
import { repeat } from './repeat.js'
import type { Shape } from './shapes.js'
import { callTexture } from './texture.js'
import { madeOf, meantByFunctions, meantByMethods, methodsOf, sameAs } from './aliases.js'
import { didYouMean, refusing } from '../checks/nearest.js'

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

/** Functions that need no `this`, so that `const { vec3, sin } = glsl` works. */
export function createBuilder(session: Session): Builder {
  installMethods()
  const builder: Builder = {
    val: (value, ...others) => {
      expectNoMore('val', others)
      return toExpression(session, 'val', value, 1)
    },
    texture: (...operands) => callTexture(session, operands),
    repeat: ((...given: unknown[]) => repeat(session, given)) as never,
    fn: ((options: unknown) => declareFunction(session, options)) as never,
    source: ((...given: unknown[]) => frontEnd()(builder, ...given)) as never,
  }
  for (const [name, shape] of Object.entries(params))
    builder[name] = (label, ...others) => {
      if (others.length > 0)
        throw new WarpError(
          `${name}: it takes only a name; there are ${Object.keys(params).join(', ')}.`,
        )
      return session.input(label, shape, name)
    }
  // For front ends, which record functions in sessions of their own: no list has it.
  Object.defineProperty(builder, 'of', { value: createBuilder })
  for (const { name, number, isListed } of getOperations()) {
    const call = (...operands: unknown[]) =>
      session.call(
        number,
        name,
        operands.map((operand, i) => toExpression(session, name, operand, i + 1)),
      )
    // Every warp has a builder of its own: an assignment takes a quarter of the time of a definition.
    if (isListed) builder[name] = call
    else Object.defineProperty(builder, name, { value: call })
  }
  for (const kind of noiseKinds) builder[kind] = (...operands) => callNoise(session, kind, operands)
  for (const [alias, name] of Object.entries(sameAs)) builder[alias] = builder[name]!
  for (const [alias, make] of Object.entries(madeOf))
    builder[alias] = (operand, ...others) =>
      make(methodsOf(toExpression(session, alias, operand, 1)), ...others)
  return Object.setPrototypeOf(
    builder,
    refusing(
      (name) =>
        `glsl.${name}: there is no such function; ${didYouMean(name, Object.keys(builder), lists, meantByFunctions)}`,
    ),
  ) as Builder
}

/** Only a session makes expressions. */
const sessionOf = (expression: Expression) => expression.session as Session

/** Methods that ask for results, as glsl-autodiff has them. */
const results = {
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

function installMethods() {
  if (installed) return
  installed = true
  for (const [name, indices] of swizzles()) defineComponents(name, indices)
  for (const { name, number, isMethod } of getOperations())
    if (isMethod)
      define(name, function (...given) {
        const session = sessionOf(this)
        if (given.length > 0 && /^rotate[XYZ]$/.test(name))
          throw new WarpError(
            `${name}: a turn is a matrix, and gives where a vertex goes; write glsl.${name}(angle).mult(v).sub(v).`,
          )
        const operands = given.map((operand, i) => toExpression(session, name, operand, i + 1))
        return session.call(number, name, [this, ...operands], true)
      })
  for (const kind of noiseKinds)
    define(kind, function (...operands) {
      return callNoise(sessionOf(this), kind, [this, ...operands], true)
    })
  for (const [name, method] of Object.entries(results)) define(name, method)
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

function define(name: string, method: (this: Expression, ...operands: unknown[]) => unknown) {
  const value = function (this: unknown, ...operands: unknown[]) {
    if (this instanceof Expression) return method.apply(this, operands)
    throw new WarpError(`${name}: call it on an expression, as in x.${name}(…).`)
  }
  Object.defineProperty(methods, name, { value, configurable: true, writable: true })
}
