// The kinds of values that operators and functions distinguish.
import { isExpression } from '../errors/describe.js'

export type Glsl = Record<string, (...operands: unknown[]) => unknown>

/** The part of an expression's session that we use. */
interface Session {
  isCondition(value: unknown): boolean
  shapeOf(value: unknown): readonly [columns: number, rows: number]
  use(value: unknown): void
}

const sessionOf = (value: unknown) => (value as { session: Session }).session

/** The prototype of p5's sketches, if p5 is a global of the page. */
export const p5Prototype = (): object =>
  (Reflect.get(globalThis, 'p5') as { prototype?: object } | undefined)?.prototype ?? {}

/** Recognizes a p5 sketch, whose functions are called as `p.sin(x)`, by its shape, since p5 may be a module. */
export const isSketch = (object: unknown): object is Record<string, unknown> =>
  typeof object === 'object' &&
  object !== null &&
  ['createCanvas', 'angleMode', 'noise'].every(
    (name) => name in object && typeof Reflect.get(object, name) === 'function',
  )

/** Returns whether a value is a vector such as those of p5's createVector or three.js' Vector3. */
export const isVectorLike = (value: unknown): value is { x: unknown; y: unknown; z?: unknown } =>
  typeof value === 'object' &&
  value !== null &&
  !isExpression(value) &&
  'x' in value &&
  'y' in value &&
  [value.x, value.y].every((component) => typeof component === 'number' || isExpression(component))

const componentsOf = (value: unknown): unknown[] =>
  Array.isArray(value)
    ? value
    : isVectorLike(value)
      ? [value.x, value.y, ...(value.z === undefined ? [] : [value.z])]
      : []

/** Returns whether a value is an expression, or an array or vector that holds one. */
export const isExpressionLike = (value: unknown): boolean =>
  isExpression(value) || componentsOf(value).some(isExpressionLike)

/** Returns whether an object of the sketch holds an expression in its own properties, up to `depth` levels deep. Getters are not called. */
export function holdsExpression(value: unknown, depth = 2): boolean {
  if (typeof value === 'function' && !isExpression(value)) return depth > 1
  if (isExpressionLike(value)) return true
  if (typeof value !== 'object' || value === null || depth === 0) return false
  return Object.values(Object.getOwnPropertyDescriptors(value)).some(
    (each) => 'value' in each && holdsExpression(each.value, depth - 1),
  )
}

/** Converts an array of 2 to 4 numbers or expressions, or an object with x and y, to a vector; returns other values unchanged. */
export function toVector(glsl: Glsl, value: unknown): unknown {
  const components = componentsOf(value)
  return components.length >= 2 && components.length <= 4
    ? glsl[`vec${components.length}`]!(...components)
    : value
}

/** Returns whether a value is a condition that differs by vertex. */
export const isCondition = (value: unknown): boolean =>
  isExpression(value) && sessionOf(value).isCondition(value)

/** Returns whether the truth of a value differs by vertex: true for a condition or a number; a vector is always true in JavaScript. */
export function decidesByVertex(value: unknown): boolean {
  if (!isExpression(value)) return false
  if (isCondition(value)) return true
  const [columns, rows] = sessionOf(value).shapeOf(value)
  return columns === 1 && rows === 1
}

/** Suppresses the warning about an unused condition. */
export const useCondition = (condition: unknown) => sessionOf(condition).use(condition)
