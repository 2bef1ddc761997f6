// The option `uniforms`: named values, whose types follow from the values that are passed when the warp is made.
import { describe, type WarpError } from '../../errors/errors.js'
import { isCallable, ownProperty } from '../../options/guards.js'
import { record, type Kind } from '../../options/kinds.js'
import { finiteDouble, readNumbers } from '../../options/numbers.js'
import type { Place } from '../../options/place.js'
import type { HostSampling } from '../expression/sampling.js'
import { imageShape, type Shape } from '../expression/shapes.js'
import type { ImageLike } from '../types/types.js'
import { inputSizes } from './inputs.js'
import {
  imageFor,
  isImage,
  numbersFor,
  numbersOf,
  scalarOrArray,
  shapeFor,
} from './uniform-values.js'

/** A uniform as the option declares it. */
export interface DeclaredUniform {
  shape: Shape
  /** Returns the current numbers; calls the user's function, if the uniform is one. Throws if they no longer have the declared type. */
  numbers: (place: Place) => number[]
  /** Returns the current value, unchecked. Present if that allocates no array. */
  value?: (() => unknown) | undefined
  isFunction: boolean
  /** Present for an image, which has no numbers: returns the current image. */
  image?: (() => ImageLike) | undefined
  /** Present for an image if the host passes its wrapping and filter to the shader. */
  sampling?: HostSampling | undefined
}

/** Maps the user's name → uniform. */
export type DeclaredUniforms = ReadonlyMap<string, DeclaredUniform>

const optionRecord = record<object>(
  'an object, such as { amount: 0.5, center: [0, 0, 0], follow: () => [mouseX, mouseY] },',
)

const expected =
  'a number, true or false, an array of 2, 3, 4, 9 or 16 numbers, a vector or colour of p5 or three.js, an image, or a function that returns one of them,'

/** The kind of the option `uniforms`. Arrays are copied, and functions are called once for the type of their result. */
export const uniformsKind: Kind<DeclaredUniforms, object> = {
  read: (option, place) =>
    new Map(
      option === undefined
        ? []
        : Object.entries(optionRecord.read(option, place.option('uniforms'))).map(
            ([name, value]: [string, unknown]) => [name, declare(name, value, place.uniform(name))],
          ),
    ),
}

function declare(name: string, option: unknown, place: Place): DeclaredUniform {
  if (Object.hasOwn(inputSizes, name))
    throw place.error(
      `the uniform "${name}" has the name of an input; give it another one, such as "my${name[0]!.toUpperCase()}${name.slice(1)}".`,
    )
  const isFunction = isCallable(option)
  const first: unknown = isFunction ? option() : option
  if (isImage(first))
    return {
      shape: imageShape,
      numbers: () => [],
      isFunction,
      image: () => (isFunction ? imageFor(place, option()) : first),
    }
  const numbers = numbersOf(first)
  const shape = shapeFor(numbers)
  if (!numbers || !shape)
    throw place.expected(
      expected,
      isFunction ? `a function that returns ${describe(first)}` : describe(first),
      // Uniforms of three.js are objects with a value.
      typeof first === 'object' && first !== null && 'value' in first
        ? 'pass its value itself'
        : undefined,
    )
  readNumbers(place, numbers, numbers.length, { test: finiteDouble, given: first })
  const value = scalarOrArray(numbers)
  if (!isFunction) return { shape, numbers: () => numbers, value: () => value, isFunction: false }
  return {
    shape,
    value: option,
    numbers: (call) => numbersFor(call.uniform(name), shape, option(), true),
    isFunction: true,
  }
}

/** Adds the current values of uniforms that are functions to those in `passed`, so that many evaluations in a row use the same values. */
export function snapshotUniforms<Values extends object>(
  place: Place,
  declared: DeclaredUniforms | undefined,
  passed: Values | undefined,
): Values | undefined {
  if (!declared?.size || (passed !== undefined && typeof passed !== 'object')) return passed
  const functions = [...declared].filter(
    ([name, { isFunction, image }]) =>
      isFunction && !image && ownProperty(passed ?? {}, name) === undefined,
  )
  const current = functions.map(([name, { numbers }]) => [name, scalarOrArray(numbers(place))])
  return { ...passed, ...Object.fromEntries(current) } as Values
}

/** Lists the user's names for a message. */
export const listNames = (declared: DeclaredUniforms) => [...declared.keys()].join(', ')

/**
 * Returns the values that a program on the CPU reads: those that were passed, and the current values of the other declared uniforms.
 * `read` has the names of the uniforms that the program reads.
 */
export function withDeclared(
  place: Place,
  declared: DeclaredUniforms,
  passed: Readonly<Record<string, unknown>> = {},
  read: ReadonlySet<string>,
): Record<string, unknown> {
  const all = Object.assign(Object.create(null), passed) as Record<string, unknown>
  for (const [name, uniform] of declared) {
    const value = ownProperty(passed, name)
    const isRead = read.has(name)
    if (uniform.image) delete all[name]
    else if (value !== undefined)
      all[name] = scalarOrArray(numbersFor(place.uniform(name), uniform.shape, value))
    else if (isRead) all[name] = scalarOrArray(uniform.numbers(place))
    if (!isRead) delete all[name]
  }
  return all
}

/** Makes the error for a uniform that the warp does not have. `names` are those that it has. */
export const unknownUniform = (place: Place, name: string, names: readonly string[]): WarpError =>
  place.error(
    `the warp has no uniform "${name}"; ${names.length ? `it has ${names.join(', ')}` : `the option "uniforms" must declare it: { uniforms: { ${name}: 0.5 } }`}.`,
  )
