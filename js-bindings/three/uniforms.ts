// The uniforms of a warp in three.js' form: objects with a `value`, which may be changed at any time.
import type { Color, Matrix3, Matrix4, Quaternion, Texture, Vector2, Vector3, Vector4 } from 'three'
import type { HostUniform, HostWarp } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'

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

/** Maps name → value, or a function that returns it. */
export type ThreeUniforms = Readonly<Record<string, ThreeUniform | (() => ThreeUniform)>>

type ValueOf<Given> = Given extends () => infer Value ? Value : Given

/** The types of the values of the option `uniforms`. */
export type ValuesOf<Given> = { -readonly [Name in keyof Given]: Widened<ValueOf<Given[Name]>> }

type Widened<Value> = Value extends number ? number : Value extends boolean ? boolean : Value

/** The values as the offset function receives them: numbers, lists of numbers and images. */
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

/** Handles like three.js' uniforms: `warped.uniforms.amount.value = 2`. A vector may be changed in place. */
export type UniformHandles<Values> = {
  readonly [Name in keyof Values]: UniformHandle<Values[Name]>
}

export interface UniformHandle<Value> {
  /** The current value. */
  get value(): Value
  /** Sets a value of the same type, or a function that returns it. */
  set value(value: Value | (() => Value))
}

/** Returns a uniform for three.js, which reads `value` whenever it sets uniforms. */
export const liveUniform = (uniform: HostUniform): { readonly value: unknown } => ({
  get value() {
    return valueNow(uniform)
  },
})

export function valueNow({ image, numbers, type }: HostUniform): unknown {
  if (image) return image()
  return type === 'float' ? numbers()[0] : numbers()
}

/** Makes the property `uniforms` of a warped object or material. */
export function handlesOf(method: string, uniforms: HostWarp['uniforms']) {
  const handles = Object.fromEntries(
    uniforms.names.map((name) => [
      name,
      {
        get value() {
          return uniforms.get(name)
        },
        set value(value: unknown) {
          uniforms.set(name, value)
        },
      },
    ]),
  )
  return rejectUnknownNames(method, uniforms, handles)
}

/** Makes handles throw a `WarpError` for an unknown name; JavaScript would say that it cannot set a property of undefined. */
const rejectUnknownNames = (
  method: string,
  uniforms: HostWarp['uniforms'],
  handles: Record<string, UniformHandle<unknown>>,
) =>
  new Proxy(Object.freeze(handles), {
    get(target, name) {
      if (typeof name === 'symbol' || Object.hasOwn(target, name)) return Reflect.get(target, name)
      // Promises, React and JSON look these up.
      if (['then', 'toJSON', '$$typeof', 'constructor', 'toString', 'valueOf'].includes(name))
        return Reflect.get(target, name)
      throw uniforms.unknown(name)
    },
    set(_, name) {
      throw new WarpError(
        `${method}: a uniform itself stays; set its value, as in uniforms.${String(name)}.value = 0.5.`,
      )
    },
  })
