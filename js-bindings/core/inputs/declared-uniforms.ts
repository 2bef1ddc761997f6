// The option `uniforms`: values that a sketch names once, where it makes its warp. Their types come from the values.
import type { Session } from '../expression/session.js'
import { WarpError, describe } from '../../errors/errors.js'
import { asOwn, readOperators } from '../../errors/operators.js'
import type { Expression } from '../expression/expression.js'
import { inputSizes, markWhole } from './inputs.js'
import { lazyObject } from '../lazy-object.js'
import { isCallable, isList, own } from '../../options/options.js'
import { type Shape, imageShape, typeOf } from '../expression/shapes.js'
import type { HostSampling } from '../expression/sampling.js'
import type { ImageLike, OffsetFunction, UniformValue, WarpInputs } from '../types/types.js'

type Given = UniformValue | (() => UniformValue)

/** A uniform as the option declares it. */
export interface DeclaredUniform {
  shape: Shape
  /** Its numbers now; a function is called. Throws if they are not of the same type any more. */
  numbers: (method: string) => number[]
  /** What it is now, unchecked, where that can be had without making an array. */
  value?: (() => unknown) | undefined
  isFunction: boolean
  /** Of an image, which has no numbers: what it is now. */
  image?: (() => ImageLike) | undefined
  /** Present for an image if the host passes its wrapping and filter to the shader. */
  sampling?: HostSampling | undefined
}

/** By the sketch's name. */
export type DeclaredUniforms = ReadonlyMap<string, DeclaredUniform>

const shapes: Record<number, Shape> = {
  1: [1, 1],
  2: [1, 2],
  3: [1, 3],
  4: [1, 4],
  9: [3, 3],
  16: [4, 4],
}

const example = '{ amount: 0.5, center: [0, 0, 0], follow: () => [mouseX, mouseY] }'

const expected =
  'a number, true or false, an array of 2, 3, 4, 9 or 16 numbers, a vector or colour of p5 or three.js, an image, or a function that gives one of them'

/** Checks the option. Lists are copied, and functions called once for their type. */
export function readDeclared(method: string, option: unknown): DeclaredUniforms {
  if (option === undefined) return new Map()
  if (typeof option !== 'object' || option === null || isList(option))
    throw new WarpError(
      `${method}: the option "uniforms" must be an object, such as ${example}, but is ${describe(option)}.`,
    )
  return new Map(
    Object.entries(option).map(([name, given]) => [name, declare(method, name, given as Given)]),
  )
}

/** The same of an option whose values, also those that functions give, `plain` makes of a host's own. */
export function readDeclaredOf(
  method: string,
  option: object | undefined,
  plain: (value: unknown) => unknown,
): DeclaredUniforms {
  const converted = Object.entries(option ?? {}).map(([name, given]: [string, unknown]) => [
    name,
    isCallable(given) ? () => plain((given as () => unknown)()) : plain(given),
  ])
  return readDeclared(method, option && Object.fromEntries(converted))
}

/** Adds `sampling` to each image. */
export const withSampling = (
  declared: DeclaredUniforms,
  sampling: HostSampling,
): DeclaredUniforms =>
  new Map(
    [...declared].map(([name, uniform]) => [
      name,
      uniform.image ? { ...uniform, sampling } : uniform,
    ]),
  )

function declare(method: string, name: string, given: Given): DeclaredUniform {
  if (Object.hasOwn(inputSizes, name))
    throw new WarpError(
      `${method}: the uniform "${name}" has the name of an input; give it another one, such as "my${name[0]!.toUpperCase()}${name.slice(1)}".`,
    )
  const isFunction = isCallable(given)
  const first = isFunction ? given() : given
  const place = `the uniform "${name}"`
  if (isImage(first))
    return {
      shape: imageShape,
      numbers: () => [],
      isFunction,
      image: () => (isFunction ? imageFor(`The warp's uniform "${name}"`, given()) : first),
    }
  const numbers = numbersOf(first)
  const known = numbers && shapes[numbers.length]
  if (!known) {
    const came = `${isFunction ? 'its function gives' : 'is'} ${describe(first)}`
    // As three.js has its own uniforms.
    const advice =
      typeof first === 'object' && first !== null && 'value' in first
        ? '; give its value itself'
        : ''
    throw new WarpError(
      `${method}: the uniform "${name}" must be ${expected}, but ${came}${advice}.`,
    )
  }
  checkFinite(`${method}: ${place}`, numbers)
  const shape: Shape = [...known]
  const value = unlisted(numbers)
  if (!isFunction) return { shape, numbers: () => numbers, value: () => value, isFunction: false }
  return {
    shape,
    value: given,
    numbers: (method) => numbersFor(`${method}: ${place}`, shape, given(), true),
    isFunction: true,
  }
}

/**
 * The numbers of a value for a uniform that is there already. `place` opens the message; `isOwn` says that the uniform's
 * own function gave the value.
 */
export function numbersFor(place: string, shape: Shape, value: unknown, isOwn = false): number[] {
  const count = shape[0] * shape[1]
  const numbers = numbersOf(value, count)
  if (numbers?.length !== count) {
    const came = numbers && shapes[numbers.length]
    const is = came ? `a ${typeOf(came)}` : describe(value)
    throw new WarpError(
      isOwn
        ? `${place} was a ${typeOf(shape)} when the warp was made, but its function now gives ${is}; it must stay what it was.`
        : `${place} is a ${typeOf(shape)} and takes ${count === 1 ? 'a number' : `an array of ${count} numbers${shape[0] > 1 ? ', column by column' : ''}`}, but ${is} came.`,
    )
  }
  checkFinite(place, numbers)
  if (wholes.has(shape)) checkWhole(place, numbers)
  return numbers
}

/** The shapes, each of one uniform, of those that shader text reads as whole numbers. */
const wholes = new WeakSet<Shape>()

export const isWhole = ({ shape }: DeclaredUniform) => wholes.has(shape)

/** They reach it as floats, which tell no larger ones apart. */
function checkWhole(place: string, numbers: readonly number[]) {
  const large = numbers.find((number) => Math.abs(number) > 2 ** 24)
  if (large)
    throw new WarpError(`${place} is read as a whole number, at most 16777216, but is ${large}.`)
}

/** What has a width and a height: p5's images, graphics, framebuffers and videos, and those of the page. */
const isImage = (value: unknown): value is ImageLike =>
  typeof value === 'object' && value !== null && 'width' in value && 'height' in value

/** A value for an image that is there already. */
export function imageFor(place: string, value: unknown): ImageLike {
  if (isImage(value)) return value
  throw new WarpError(
    `${place} must be an image, such as one of loadImage or createGraphics, but is ${describe(value)}.`,
  )
}

/**
 * Nothing if it is no value of a uniform. A p5.Vector has three numbers and a p5.Color four, of which the first are taken
 * where a shorter vector is wanted.
 */
function numbersOf(value: unknown, count = Infinity): number[] | undefined {
  if (typeof value === 'number') return [value]
  if (typeof value === 'boolean') return [Number(value)]
  if (isList(value)) return value.length > 1 ? Array.from(value) : undefined
  if (typeof value !== 'object' || value === null) return undefined
  const list = componentsOf(value)
  if (!isList(list)) return undefined
  const numbers = Array.from(list)
  return count > 1 ? numbers.slice(0, count) : numbers
}

/** The numbers of a p5.Vector or p5.Color; of anything else itself. */
export function componentsOf(value: object): unknown {
  if ('x' in value && 'y' in value && 'z' in value) return [value.x, value.y, value.z]
  return '_array' in value ? value._array : value
}

function checkFinite(place: string, numbers: readonly unknown[]) {
  const wrong = numbers.find((number) => !Number.isFinite(number))
  if (wrong === undefined && !numbers.includes(undefined)) return
  const came = typeof wrong === 'number' ? wrong : describe(wrong)
  throw new WarpError(
    numbers.length === 1
      ? `${place} must be a finite number, but is ${came}.`
      : `${place} must have finite numbers, but has ${came} among them.`,
  )
}

/** A single number by itself, as everybody takes it. */
export const unlisted = (numbers: number[]) => (numbers.length === 1 ? numbers[0]! : numbers)

/** For many evaluations in a row, which must agree: the functions' values of this moment, but for what is given. */
export function settled<Values extends object>(
  method: string,
  declared: DeclaredUniforms | undefined,
  given: Values | undefined,
): Values | undefined {
  if (!declared?.size || (given !== undefined && typeof given !== 'object')) return given
  const functions = [...declared].filter(
    ([name, { isFunction, image }]) => isFunction && !image && own(given ?? {}, name) === undefined,
  )
  const now = functions.map(([name, { numbers }]) => [name, unlisted(numbers(method))])
  return { ...given, ...Object.fromEntries(now) } as Values
}

/** What the sketch calls its uniforms, for a message. */
export const listed = (declared: DeclaredUniforms) => [...declared.keys()].join(', ')

/** The offset function, with its operators read, and with `uniforms` among its inputs; `labelOf` gives what the shader calls them. */
export function withUniforms(
  method: string,
  offset: OffsetFunction,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string = (name) => name,
): OffsetFunction {
  const read = readOperators(offset, { method })
  return asOwn((inputs: WarpInputs) => {
    const strings = Reflect.ownKeys(inputs).filter((name) => typeof name === 'string')
    const names = new Map([...strings, 'uniforms'].map((name) => [name, true]))
    const make = (name: string) => {
      if (name !== 'uniforms') return inputs[name as keyof WarpInputs]
      const { session } = inputs.position as unknown as Expression
      return expressions(method, session as Session, declared, labelOf)
    }
    // What is no input still says so.
    return read(lazyObject(Object.getPrototypeOf(inputs) as object, { names, make }) as WarpInputs)
  })
}

/** An object of expressions, and of images' names, which says so where there is none of that name. */
function expressions(
  method: string,
  session: Session,
  declared: DeclaredUniforms,
  labelOf: (name: string) => string,
): WarpInputs['uniforms'] {
  const known = Object.create(null) as object
  for (const [name, { shape, sampling }] of declared) {
    const label = labelOf(name)
    if (sampling) session.samplings.set(label, sampling)
    Object.defineProperty(known, name, {
      enumerable: true,
      get: () =>
        shape === imageShape ? label : session.input(label, shape, `${method} uniforms.${name}`),
    })
  }
  Object.defineProperty(known, markWhole, {
    value: (name: string) => {
      const { shape, isFunction, numbers } = declared.get(name)!
      wholes.add(shape)
      if (!isFunction) checkWhole(`${method}: the uniform "${name}"`, numbers(method))
    },
  })
  return new Proxy(known, {
    get(target, name) {
      if (name in target || typeof name === 'symbol') return Reflect.get(target, name)
      throw new WarpError(
        declared.size
          ? `${method}: the option "uniforms" declares no "${name}"; there are ${listed(declared)}.`
          : `${method}: the offset reads uniforms.${name}, which nothing declares; add the option { uniforms: { ${name}: 0.5 } }.`,
      )
    },
    set(_, name) {
      throw new WarpError(
        `${method}: uniforms.${String(name)} cannot be set in the offset function; give its value in the option "uniforms", or where the warp is used.`,
      )
    },
  })
}

/** For the CPU: what is given, and for the rest of what is declared its present value, as far as it is `read`. */
export function withDeclared(
  method: string,
  declared: DeclaredUniforms,
  given: Readonly<Record<string, unknown>> = {},
  read: ReadonlySet<string>,
): Record<string, unknown> {
  const all = Object.assign(Object.create(null), given) as Record<string, unknown>
  for (const [name, uniform] of declared) {
    const value = own(given, name)
    const isRead = read.has(name)
    if (uniform.image) delete all[name]
    else if (value !== undefined)
      all[name] = unlisted(numbersFor(`${method}: the uniform "${name}"`, uniform.shape, value))
    else if (isRead) all[name] = unlisted(uniform.numbers(method))
    if (!isRead) delete all[name]
  }
  return all
}

/** That a host is asked for a uniform which the option "uniforms" does not declare; `names` are those that it does. */
export const unknownUniform = (method: string, name: string, names: readonly string[]) =>
  new WarpError(
    `${method}: the warp has no uniform "${name}"; ${names.length ? `there ${names.length > 1 ? 'are' : 'is'} ${names.join(', ')}` : `the option "uniforms" must declare it: { uniforms: { ${name}: 0.5 } }`}.`,
  )
