// What options of deformers may be: numbers, vectors and axes, each a constant, an expression, or a function of what the
// offset function is given.
import { isExpression as hasItsShape } from '../errors/describe.js'
import { isList } from '../options/options.js'
import { mostSeed } from '../wasm/tables.js'
import type { Glsl, Operand, Scalar, Vec3, WarpInputs } from '../core/types/types.js'

/** What an offset function is given. Which uniforms there are is said where the warp is made, which is elsewhere. */
export type OptionInputs = WarpInputs & { uniforms: { readonly [name: string]: any } }

/** A value, or what computes it where the warp is made: `({ uniforms }) => uniforms.amount`. */
export type OrFunction<Value> = Value | ((inputs: OptionInputs) => Value)

/** A number; an expression made inside of the same warp; or a function that gives one of them. */
export type NumberOption = OrFunction<Operand>

/** Three numbers or expressions; a vec3 made inside of the same warp; or a function that gives one of them. */
export type VectorOption = OrFunction<Vec3 | Triple>
export type Triple = readonly [Operand, Operand, Operand]

/** A direction of any length: an axis by its name, or a vector. One that is computed and has length 0 moves nothing. */
export type AxisOption = OrFunction<AxisName | Vec3 | Triple>
export type AxisName = 'x' | 'y' | 'z'

export interface Kind<Value> {
  /** What stands for an option that is left out. */
  standard: unknown
  /** What a constant must be, for messages. */
  expected: string
  /** How many numbers an expression has; 0 if only constants will do. */
  rows: 0 | 1 | 3
  /** Whether this, which is neither an expression nor a function, will do. */
  allows(value: unknown): boolean
  make(glsl: Glsl, value: never): Value
}

export const isExpression = (value: unknown): value is Scalar | Vec3 => hasItsShape(value)

const isNumber = (value: unknown) =>
  typeof value === 'number' && Number.isFinite(Math.fround(value))

const isTriple = (value: unknown): value is Triple =>
  isList(value) &&
  value.length === 3 &&
  Array.from(value).every((x) => isNumber(x) || isExpression(x))

export const number = (standard: number): Kind<Scalar> => ({
  standard,
  expected: 'a number',
  rows: 1,
  allows: isNumber,
  make: (glsl, value: number) => glsl.val(value),
})

/** A whole number, one that seeds may be, which must be there when the deformer is made. */
export const whole = (standard: number): Kind<number> => ({
  standard,
  expected: `a whole number of at most ${mostSeed}`,
  rows: 0,
  allows: (value) => Number.isInteger(value) && Math.abs(value as number) <= mostSeed,
  make: (_, value: number) => value,
})

export const flag = (standard: boolean): Kind<boolean> => ({
  standard,
  expected: 'true or false',
  rows: 0,
  allows: (value) => typeof value === 'boolean',
  make: (_, value: boolean) => value,
})

/** What is computed and gets no larger than that counts as this: formulas divide by it. */
const smallest = 1e-6

/** A number above 0. */
export const positive = (standard: number): Kind<Scalar> => ({
  standard,
  expected: 'a number above 0',
  rows: 1,
  allows: (value) => isNumber(value) && (value as number) > 0,
  make: (glsl, value: number) =>
    isExpression(value) ? glsl.max(value, smallest) : glsl.val(value),
})

export const vector = (
  standard: Triple | ((inputs: WarpInputs) => Vec3) = [0, 0, 0],
): Kind<Vec3> => ({
  standard,
  expected: 'an array of 3 finite numbers',
  rows: 3,
  allows: isTriple,
  make: (glsl, value: Vec3 | Triple) => (isExpression(value) ? value : glsl.vec3(...value)),
})

const unit = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const

/** A constant direction as three numbers of length 1, or nothing for one that is computed. */
export function constantDirection(value: unknown): number[] | undefined {
  if (Object.keys(unit).includes(value as string)) return [...unit[value as AxisName]]
  if (!isList(value) || !Array.from(value).every(isNumber)) return undefined
  const length = Math.hypot(...Array.from(value))
  return Array.from(value, (x) => x / length)
}

/** A direction, of length 1 when it is made. */
export const axis = (standard: AxisName): Kind<Vec3> => ({
  standard,
  expected: '"x", "y", "z" or an array of 3 finite numbers that are not all 0',
  rows: 3,
  allows: (value) =>
    (isTriple(value) && Array.from(value).some((x) => x !== 0)) ||
    Object.keys(unit).includes(value as string),
  make(glsl, value: AxisName | Vec3 | Triple) {
    const direction = constantDirection(value)
    if (direction) return glsl.vec3(...direction)
    return (isExpression(value) ? value : glsl.vec3(...(value as Triple))).normalize()
  },
})

/** Nothing unless it is given. */
export const optional = <Value>(kind: Kind<Value>): Kind<Value | undefined> => ({
  ...kind,
  standard: undefined,
  allows: (value) => value === undefined || kind.allows(value),
  make: (glsl, value) => (value === undefined ? undefined : kind.make(glsl, value)),
})
