// The option `uniforms`: values that a sketch names once, where it makes its warp. Their types come from the values.
import { WarpError, describe } from '../../errors/errors.js'
import { isCallable, isList, own } from '../../options/options.js'
import type { HostSampling } from '../expression/sampling.js'
import { type Shape, imageShape } from '../expression/shapes.js'
import type { ImageLike, UniformValue } from '../types/types.js'
import { inputSizes } from './inputs.js'
import {
  checkFinite,
  imageFor,
  isImage,
  numbersFor,
  numbersOf,
  scalarOrArray,
  shapeFor,
} from './uniform-values.js'

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
  const shape = shapeFor(numbers)
  if (!numbers || !shape) {
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
  const value = scalarOrArray(numbers)
  if (!isFunction) return { shape, numbers: () => numbers, value: () => value, isFunction: false }
  return {
    shape,
    value: given,
    numbers: (method) => numbersFor(`${method}: ${place}`, shape, given(), true),
    isFunction: true,
  }
}

/** For many evaluations in a row, which must agree: the functions' values of this moment, but for what is given. */
export function snapshotUniforms<Values extends object>(
  method: string,
  declared: DeclaredUniforms | undefined,
  given: Values | undefined,
): Values | undefined {
  if (!declared?.size || (given !== undefined && typeof given !== 'object')) return given
  const functions = [...declared].filter(
    ([name, { isFunction, image }]) => isFunction && !image && own(given ?? {}, name) === undefined,
  )
  const now = functions.map(([name, { numbers }]) => [name, scalarOrArray(numbers(method))])
  return { ...given, ...Object.fromEntries(now) } as Values
}

/** What the sketch calls its uniforms, for a message. */
export const listNames = (declared: DeclaredUniforms) => [...declared.keys()].join(', ')

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
      all[name] = scalarOrArray(
        numbersFor(`${method}: the uniform "${name}"`, uniform.shape, value),
      )
    else if (isRead) all[name] = scalarOrArray(uniform.numbers(method))
    if (!isRead) delete all[name]
  }
  return all
}

/** That a host is asked for a uniform which the option "uniforms" does not declare; `names` are those that it does. */
export const unknownUniform = (method: string, name: string, names: readonly string[]) =>
  new WarpError(
    `${method}: the warp has no uniform "${name}"; ${names.length ? `there ${names.length > 1 ? 'are' : 'is'} ${names.join(', ')}` : `the option "uniforms" must declare it: { uniforms: { ${name}: 0.5 } }`}.`,
  )
