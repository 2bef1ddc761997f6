// The kinds of deformers' options: numbers, vectors and axes. Each is a constant, an expression, or a function of the inputs
// of an offset function. Constants are checked immediately, computed values when the warp is made.
import type { Expression } from '../core/expression/expression.js'
import type { Shape } from '../core/expression/shapes.js'
import type { Glsl, Operand, Scalar, Vec3, WarpInputs } from '../core/types/types.js'
import { describe, describeShape, isExpression as isAnyExpression } from '../errors/describe.js'
import { translateOperators } from '../errors/operators.js'
import { isCallable, isFiniteFloat, isList } from '../options/guards.js'
import { wholeNumber, type Kind } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { maxSeed } from '../wasm/tables.js'

/** The inputs of an offset function. The uniforms are untyped, since they are declared elsewhere, where the warp is made. */
export type OptionInputs = WarpInputs & { uniforms: { readonly [name: string]: any } }

/** A value, or a function that computes it when the warp is made: `({ uniforms }) => uniforms.amount`. */
export type OrFunction<Value> = Value | ((inputs: OptionInputs) => Value)

/** A number; an expression made inside of the same warp; or a function that returns one of these. */
export type NumberOption = OrFunction<Operand>

/** Three numbers or expressions; a vec3 made inside of the same warp; or a function that returns one of these. */
export type VectorOption = OrFunction<Vec3 | Triple>
export type Triple = readonly [Operand, Operand, Operand]

/** A direction of any length: the name of an axis, or a vector. A computed direction of length 0 moves nothing. */
export type AxisOption = OrFunction<AxisName | Vec3 | Triple>
export type AxisName = 'x' | 'y' | 'z'

export const isExpression = (value: unknown): value is Scalar | Vec3 => isAnyExpression(value)

/** A value that is made inside of a warp. */
export type Computed<Value> = (inputs: WarpInputs) => Value

interface Settings<Value> {
  /** Replaces `undefined`. Without it, the value is required. */
  default?: unknown
  /** Describes a constant in messages. */
  expected: string
  /** The number of components of an expression. */
  rows: 1 | 3
  acceptsConstant(value: unknown): boolean
  /** Makes the value from a constant or an expression. */
  make(glsl: Glsl, value: never): Value
}

const shapes = { 1: 'an expression of one number', 3: 'a vec3' }

/** Returns the kind of an option that may be computed. Constants are checked when the option is read, computed values when they are made. */
const computedKind = <Given, Value>(settings: Settings<Value>): Kind<Computed<Value>, Given> => ({
  read(option, place) {
    const { default: defaultValue, expected, rows, acceptsConstant, make } = settings
    const valueOrFunction = option === undefined ? defaultValue : option
    const compute = isCallable(valueOrFunction)
      ? translateOperators(valueOrFunction, { method: `${place}` })
      : undefined
    const valueError = (got: string) =>
      compute
        ? place.error(
            `expected the function of ${place.subject} to return ${expected} or ${shapes[rows]}, got ${got}.`,
          )
        : place.expected(`${expected}, ${shapes[rows]}, or a function that returns one`, got)
    if (!compute && !isExpression(valueOrFunction) && !acceptsConstant(valueOrFunction))
      throw valueError(describe(valueOrFunction))
    return (inputs) => {
      const value: unknown = compute ? compute(inputs as never) : valueOrFunction
      if (isExpression(value)) {
        const shape = shapeOf(value, inputs, place)
        if (`${shape}` !== `1,${rows}`) throw valueError(describeShape(shape))
      } else if (!acceptsConstant(value)) throw valueError(describe(value))
      return make(inputs.glsl, value as never)
    }
  },
})

function shapeOf(value: unknown, inputs: WarpInputs, place: Place): Shape {
  const expression = value as Expression
  const { session } = inputs.position as unknown as Expression
  if (expression.session === session) return session.shapeOf(expression)
  throw place.error(
    `${place.subject} belongs to another warp; pass a function such as ({ millis }) => millis.div(1000), or make the deformer inside of the offset function.`,
  )
}

export const number = (defaultValue?: number) =>
  computedKind<NumberOption, Scalar>({
    default: defaultValue,
    expected: 'a number',
    rows: 1,
    acceptsConstant: isFiniteFloat,
    make: (glsl, value: number) => glsl.val(value),
  })

/** The kind of seeds: a whole number. */
export const seed = (defaultValue: number) =>
  wholeNumber({ min: -maxSeed, max: maxSeed, default: defaultValue })

/** The minimum of computed values: formulas divide by them. */
const minComputed = 1e-6

/** The kind of a number above 0. */
export const positive = (defaultValue: number) =>
  computedKind<NumberOption, Scalar>({
    default: defaultValue,
    expected: 'a number above 0',
    rows: 1,
    acceptsConstant: (value) => isFiniteFloat(value) && value > 0,
    make: (glsl, value: number) =>
      isExpression(value) ? glsl.max(value, minComputed) : glsl.val(value),
  })

const isTriple = (value: unknown): value is Triple =>
  isList(value) &&
  value.length === 3 &&
  Array.from(value).every((x) => isFiniteFloat(x) || isExpression(x))

export const vector = (defaultValue: Triple | ((inputs: WarpInputs) => Vec3) = [0, 0, 0]) =>
  computedKind<VectorOption, Vec3>({
    default: defaultValue,
    expected: 'an array of 3 finite numbers',
    rows: 3,
    acceptsConstant: isTriple,
    make: (glsl, value: Vec3 | Triple) => (isExpression(value) ? value : glsl.vec3(...value)),
  })

const unit = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const

/** Returns a constant direction as three numbers, scaled to length 1; `undefined` for a computed one. */
export function constantDirection(value: unknown): number[] | undefined {
  if (Object.keys(unit).includes(value as string)) return [...unit[value as AxisName]]
  if (!isList(value) || !Array.from(value).every(isFiniteFloat)) return undefined
  const length = Math.hypot(...Array.from(value))
  return Array.from(value, (x) => x / length)
}

/** The kind of a direction, which is normalized. */
export const axis = (defaultValue?: AxisName) =>
  computedKind<AxisOption, Vec3>({
    default: defaultValue,
    expected: '"x", "y", "z" or an array of 3 finite numbers that are not all 0',
    rows: 3,
    acceptsConstant: (value) =>
      (isTriple(value) && Array.from(value).some((x) => x !== 0)) ||
      Object.keys(unit).includes(value as string),
    make(glsl, value: AxisName | Vec3 | Triple) {
      const direction = constantDirection(value)
      if (direction) return glsl.vec3(...direction)
      return (isExpression(value) ? value : glsl.vec3(...(value as Triple))).normalize()
    },
  })
