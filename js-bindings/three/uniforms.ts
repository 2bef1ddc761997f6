// The uniforms of a warp, as three.js has them: objects with a `value`, which may be changed at any time.
import {
  type Color,
  type Matrix3,
  type Matrix4,
  MirroredRepeatWrapping,
  NearestFilter,
  type Quaternion,
  RepeatWrapping,
  type Texture,
  type Vector2,
  type Vector3,
  type Vector4,
  type Wrapping,
} from 'three'
import { WarpError, describe } from '../errors/errors.js'
import { isCallable } from '../options/options.js'
import { type Shape, imageShape } from '../core/expression/shapes.js'
import { hostWraps, samplingUniforms } from '../core/expression/sampling.js'
import {
  type DeclaredUniforms,
  numbersFor,
  readDeclaredOf,
  unknownUniform,
  unlisted,
  withSampling,
} from '../core/inputs/declared-uniforms.js'

/** The value of a uniform. */
export type ThreeUniform =
  | number
  | boolean
  | ArrayLike<number>
  | Vector2
  | Vector3
  | Vector4
  | Quaternion
  | Color
  | Matrix3
  | Matrix4
  | Texture

/** By name a value, or a function that gives it. */
export type ThreeUniforms = Readonly<Record<string, ThreeUniform | (() => ThreeUniform)>>

type ValueOf<Given> = Given extends () => infer Value ? Value : Given

/** What the offset function and the warp's user have of the option `uniforms`. */
export type ValuesOf<Given> = { -readonly [Name in keyof Given]: Widened<ValueOf<Given[Name]>> }

type Widened<Value> = Value extends number ? number : Value extends boolean ? boolean : Value

/** By what an offset function has for them, the values as lists of numbers and images. */
export type PlainOf<Values> = { readonly [Name in keyof Values]: Plain<Values[Name]> }

type Plain<Value> = Value extends Vector2
  ? readonly [number, number]
  : Value extends Vector3 | Color
    ? readonly [number, number, number]
    : Value extends Vector4 | Quaternion
      ? readonly [number, number, number, number]
      : Value extends Matrix3
        ? Numbers<9>
        : Value extends Matrix4
          ? Numbers<16>
          : Value extends Texture
            ? { readonly width: number; readonly height: number }
            : Value

interface Numbers<Count> extends ArrayLike<number> {
  readonly length: Count & number
}

/** As in three.js: `warped.uniforms.amount.value = 2`. A vector may be changed in place. */
export type UniformHandles<Values> = {
  readonly [Name in keyof Values]: UniformHandle<Values[Name]>
}

export interface UniformHandle<Value> {
  /** What it is now. */
  get value(): Value
  /** A value of the same type, or a function that gives it. */
  set value(value: Value | (() => Value))
}

/** One uniform, by what the shader calls it. */
export interface Uniform {
  label: string
  shape: Shape
  /** Its numbers now. */
  numbers: () => number[]
  /** For three.js, which asks for `value` whenever it sets uniforms. */
  inShader: { readonly value: unknown }
}

/** What `inputs/declared-uniforms.ts` knows: lists of numbers, and what has a width and a height. */
function plain(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value
  const it = value as Partial<Vector4 & Color & Matrix4 & Texture>
  if (it.isTexture) return { width: 1, height: 1, texture: value }
  if (Array.isArray(it.elements)) return it.elements
  if (it.isColor) return [it.r, it.g, it.b]
  if ('x' in it && 'y' in it) return [it.x, it.y, it.z, it.w].filter((part) => part !== undefined)
  return value
}

const valueOf = (given: unknown) => plain(isCallable(given) ? (given as () => unknown)() : given)

function textureFor(place: string, value: unknown): Texture {
  const { texture } = (value ?? {}) as { texture?: Texture }
  if (texture) return texture
  throw new WarpError(`${place} must be a texture of three.js, but is ${describe(value)}.`)
}

const wrapNumber = (wrapping: Wrapping) => {
  if (wrapping === RepeatWrapping) return hostWraps.repeat
  return wrapping === MirroredRepeatWrapping ? hostWraps.mirror : hostWraps.clamp
}

/** Uniforms for a texture's wrapping and filter, and for the matrix of its `offset`, `repeat` and `rotation`. */
function samplingOf(label: string, read: () => Texture): Uniform[] {
  const names = samplingUniforms(label)
  const settings = () => {
    const { wrapS, wrapT, magFilter } = read()
    return [wrapNumber(wrapS), wrapNumber(wrapT), Number(magFilter === NearestFilter)]
  }
  const transform = () => {
    const texture = read()
    if (texture.matrixAutoUpdate) texture.updateMatrix()
    return [...texture.matrix.elements]
  }
  const uniform = (label: string, shape: Shape, numbers: () => number[]): Uniform => ({
    label,
    shape,
    numbers,
    inShader: {
      get value() {
        return numbers()
      },
    },
  })
  return [uniform(names.settings, [1, 3], settings), uniform(names.transform, [3, 3], transform)]
}

/** Reads the option `uniforms`. */
export function readUniforms(method: string, option: object | undefined) {
  const declared = withSampling(readDeclaredOf(method, option, plain), { hasTransform: true })
  const handles: Record<string, { value: unknown }> = {}
  const uniforms = [...declared].flatMap(([name, { shape, image }], i): Uniform[] => {
    let given: unknown = (option as Record<string, unknown>)[name]
    const place = `The warp's uniform "${name}"`
    if (image) textureFor(place, valueOf(given))
    const numbers = () => (image ? [] : numbersFor(place, shape, valueOf(given)))
    const read = () =>
      image ? textureFor(place, valueOf(given)) : unlisted(numbersFor(place, shape, valueOf(given)))
    handles[name] = {
      get value() {
        return isCallable(given) ? (given as () => unknown)() : given
      },
      set value(value) {
        // Looked at here, where the mistake is.
        if (image) textureFor(place, valueOf(value))
        else numbersFor(place, shape, valueOf(value))
        given = value
      },
    }
    const inShader = {
      get value() {
        return read()
      },
    }
    const label = `warpjet${i}`
    const uniform = { label, shape, numbers, inShader }
    return image
      ? [uniform, ...samplingOf(label, () => textureFor(place, valueOf(given)))]
      : [uniform]
  })
  const labels = new Map([...declared.keys()].map((name, i) => [name, `warpjet${i}`]))
  return { declared, uniforms, labels, handles: sealed(method, handles) }
}

/** A name that is none says so, where JavaScript would say that it cannot set a property of undefined. */
const sealed = (method: string, handles: Record<string, { value: unknown }>) =>
  new Proxy(Object.freeze(handles), {
    get(target, name) {
      if (typeof name === 'symbol' || Object.hasOwn(target, name)) return Reflect.get(target, name)
      // What promises, React and JSON look for.
      if (['then', 'toJSON', '$$typeof', 'constructor', 'toString', 'valueOf'].includes(name))
        return Reflect.get(target, name)
      throw unknownUniform(method, name, Object.keys(target))
    },
    set(_, name) {
      throw new WarpError(
        `${method}: a uniform itself stays; set its value, as in uniforms.${String(name)}.value = 0.5.`,
      )
    },
  })

/** For the CPU, by what the shader calls them, with their numbers of the moment. */
export const onCpu = (uniforms: readonly Uniform[]): DeclaredUniforms =>
  new Map(
    uniforms.map(({ label, shape, numbers }) => [
      label,
      {
        shape,
        numbers,
        isFunction: true,
        ...(shape === imageShape && { image: () => ({ width: 1, height: 1 }) }),
      },
    ]),
  )
