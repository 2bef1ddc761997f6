// `glsl`, the builder: makes inputs and constants, and has every operation as a function. Operations are also methods of
// expressions.
import { WarpError } from '../../errors/errors.js'
import { frontEndKey } from '../../errors/front-end.js'
import { didYouMean, throwingPrototype } from '../../errors/nearest.js'
import { Place } from '../../options/place.js'
import { lazyObject } from '../lazy-object.js'
import { aliases, compositions, meantByFunctions, methodsOf, operationLists } from './aliases.js'
import { gatherNumbers } from './by-component.js'
import { toExpression, type Expression } from './expression.js'
import { declareFunction } from './host-functions.js'
import { installMethods, rejectMore } from './methods.js'
import { callNoise, noiseKinds } from './noise.js'
import { getOperations, type Operation } from './operations.js'
import { repeat } from './repeat.js'
import type { Session } from './session.js'
import type { Shape } from './shapes.js'
import { callTexture } from './texture.js'

export type Builder = Record<string, (...operands: unknown[]) => Expression>

const params: Record<string, Shape> = {
  param: [1, 1],
  vec2Param: [1, 2],
  vec3Param: [1, 3],
  vec4Param: [1, 4],
  mat2Param: [2, 2],
  mat3Param: [3, 3],
  mat4Param: [4, 4],
}

type BuilderFunction = (...args: unknown[]) => unknown

/** Makes one function of `glsl` for a session. */
type Maker = (session: Session, glsl: Builder) => BuilderFunction

/** Maps name → maker. Filled when the first builder is made. */
const makers = new Map<string, Maker>()
/** Maps name → whether it is enumerable; functions that only GLSL source needs are not. */
const listed = new Map<string, boolean>()

/** Makes `glsl`. Its functions need no `this`, so that `const { vec3, sin } = glsl` works. */
export function createBuilder(session: Session): Builder {
  if (makers.size === 0) installMakers()
  const message = (name: string) =>
    `glsl.${name}: there is no such function; ${didYouMean(name, Object.keys(glsl), operationLists, meantByFunctions)}`
  const glsl = lazyObject(throwingPrototype(message), {
    names: listed,
    make: (name) => makers.get(name)!(session, glsl),
  }) as Builder
  return glsl
}

function installMakers() {
  const add = (name: string, make: Maker, isListed = true) => {
    makers.set(name, make)
    listed.set(name, isListed)
  }
  add('val', constant)
  add(
    'texture',
    (session) =>
      (...args) =>
        callTexture(session, args),
  )
  add(
    'repeat',
    (session) =>
      (...args) =>
        repeat(session, args),
  )
  add('fn', (session) => (options) => declareFunction(session, options))
  add(
    'source',
    (_, glsl) =>
      (...args) =>
        frontEnd()(glsl, ...args),
  )
  for (const [name, shape] of Object.entries(params)) add(name, parameter(name, shape))
  // For front ends, which record functions in sessions of their own; not enumerable.
  add('of', () => createBuilder as BuilderFunction, false)
  for (const each of getOperations().values()) add(each.name, functionOf(each), each.isListed)
  for (const kind of noiseKinds)
    add(
      kind,
      (session) =>
        (...args) =>
          callNoise(session, kind, args),
    )
  for (const [alias, name] of Object.entries(aliases)) add(alias, (_, glsl) => glsl[name]!)
  for (const alias of Object.keys(compositions)) add(alias, composition(alias))
  installMethods()
}

function frontEnd(): (builder: Builder, ...args: unknown[]) => unknown {
  const read = Reflect.get(globalThis, frontEndKey) as ReturnType<typeof frontEnd> | undefined
  if (read) return read
  throw new WarpError("source: import 'warpjet/glsl' first, which reads GLSL source.")
}

const valPlace = new Place('val')

const constant: Maker =
  (session) =>
  (value, ...others) => {
    rejectMore(valPlace.method, others)
    return toExpression(session, value, valPlace, 1)
  }

const parameter =
  (name: string, shape: Shape): Maker =>
  (session) =>
  (label, ...others) => {
    if (others.length > 0)
      throw new Place(name).error(
        `it takes only a name; the functions for other types are ${Object.keys(params).join(', ')}.`,
      )
    return session.input(label, shape, name)
  }

const functionOf =
  (operation: Operation): Maker =>
  (session) =>
  (...args) => {
    const { name, place } = operation
    const operands = args.map((operand, i) => toExpression(session, operand, place, i + 1))
    return session.call(operation, gatherNumbers(session, name, operands))
  }

/** Makes the function of a composed method. */
function composition(alias: string): Maker {
  const place = new Place(alias)
  const compose = compositions[alias]!
  return (session) =>
    (operand, ...others) =>
      compose(methodsOf(toExpression(session, operand, place, 1)), ...others)
}
