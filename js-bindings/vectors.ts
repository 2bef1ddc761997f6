// Functions that are compositions of operations, so that none needs a derivative rule of its own.
// Formulas: the GLSL ES 3.00 specification, chapter 8. Angles are in radians.
import type { Compilation } from './compilation.js'
import { WarpError } from './errors.js'
import { Expression, sizeName, toExpression } from './expression.js'
import { commonSize, operation } from './operations.js'

const [add, sub, mult, div] = [
  operation('add'),
  operation('sub'),
  operation('mult'),
  operation('div'),
]
const [sqrt, inversesqrt] = [operation('sqrt'), operation('inversesqrt')]
const [clamp, ifElse, gt] = [operation('clamp'), operation('ifElse'), operation('gt')]

export interface Composition {
  /** `v` for a vector, `s` for a scalar, `x` for either; one letter an operand. */
  operands: string
  compose: (...operands: Expression[]) => Expression
}

function components(vector: Expression): Expression[] {
  return vector.ids.map((id) => new Expression(vector.compilation, [id]))
}

function vector(parts: Expression[]): Expression {
  return new Expression(
    parts[0]!.compilation,
    parts.flatMap(({ ids }) => ids),
  )
}

function dot(a: Expression, b: Expression): Expression {
  return components(mult(a, b)).reduce((sum, product) => add(sum, product))
}

/** Zero at zero, value and derivative, where the formula has none. */
function normalize(v: Expression): Expression {
  const squared = dot(v, v)
  const isPositive = gt(squared, 0)
  // Of a constant zero there is no inverse root that could fold. Equal conditions are one node.
  if (isPositive.ids[0] === gt(mult(squared, 0), 0).ids[0]) return v
  return mult(v, ifElse(isPositive, inversesqrt(squared), 0))
}

function cross(a: Expression, b: Expression): Expression {
  const [ax, ay, az] = components(a) as [Expression, Expression, Expression]
  const [bx, by, bz] = components(b) as [Expression, Expression, Expression]
  return vector([
    sub(mult(ay, bz), mult(az, by)),
    sub(mult(az, bx), mult(ax, bz)),
    sub(mult(ax, by), mult(ay, bx)),
  ])
}

function smoothstep(low: Expression, high: Expression, x: Expression): Expression {
  const t = clamp(div(sub(x, low), sub(high, low)), 0, 1)
  return mult(mult(t, t), add(mult(t, -2), 3))
}

const length = (v: Expression) => sqrt(dot(v, v))
const distance = (a: Expression, b: Expression) => length(sub(a, b))

export const compositions: Record<string, Composition> = {
  dot: { operands: 'vv', compose: dot },
  cross: { operands: 'vv', compose: cross },
  length: { operands: 'v', compose: length },
  dist: { operands: 'vv', compose: distance },
  distance: { operands: 'vv', compose: distance },
  normalize: { operands: 'v', compose: normalize },
  scale: { operands: 'xs', compose: mult },
  smoothstep: { operands: 'xxx', compose: smoothstep },
  radians: { operands: 'x', compose: (degrees) => mult(degrees, Math.PI / 180) },
  degrees: { operands: 'x', compose: (radians) => mult(radians, 180 / Math.PI) },
}

export function compose(
  compilation: Compilation,
  name: string,
  given: readonly unknown[],
  receiver?: Expression,
): Expression {
  const { operands, compose } = compositions[name]!
  const receivers = receiver ? 1 : 0
  if (given.length !== operands.length - receivers)
    throw new WarpError(
      `${name}: the number of arguments must be ${operands.length - receivers}, but is ${given.length}.`,
    )
  const expressions = given.map((operand, i) => toExpression(compilation, name, operand, i + 1))
  if (receiver) expressions.unshift(receiver)
  for (const [i, { ids }] of expressions.entries()) {
    const place = i < receivers ? 'what it is called on' : `argument ${i + 1 - receivers}`
    if (operands[i] === 'v' && ids.length === 1)
      throw new WarpError(`${name}: ${place} must be a vector, but is a single number.`)
    if (operands[i] === 's' && ids.length !== 1)
      throw new WarpError(
        `${name}: ${place} must be a single number, but is ${sizeName(ids.length)}.`,
      )
    if (name === 'cross' && ids.length !== 3)
      throw new WarpError(`${name}: ${place} must be a vec3, but is ${sizeName(ids.length)}.`)
  }
  expressions.reduce((size, operand) => commonSize(name, size, operand), 1)
  return compose(...expressions)
}

/** `vec3(x, y, z)`, `vec3(xy, z)`, `vec3(x)`. */
export function construct(compilation: Compilation, size: number, given: readonly unknown[]) {
  const name = `vec${size}`
  const parts = given.map((part, i) => toExpression(compilation, name, part, i + 1))
  // A condition becomes 0 or 1 here, as it does in any sum.
  const all = parts.flatMap((part) => components(add(part, 0)))
  if (all.length === 1) return vector(new Array<Expression>(size).fill(all[0]!))
  if (all.length !== size)
    throw new WarpError(`${name}: ${size} components were expected, but ${all.length} came.`)
  return vector(all)
}

/** All selections of components: `x`, `xy`, `zyx`, `rgba`, `st`, with their indices. */
export function* swizzles(): Generator<[name: string, indices: number[]]> {
  for (const letters of ['xyzw', 'rgba', 'stpq']) {
    let names: [string, number[]][] = [['', []]]
    for (let length = 1; length <= 4; length++) {
      names = names.flatMap(([name, indices]) =>
        [...letters].map((letter, i): [string, number[]] => [name + letter, [...indices, i]]),
      )
      yield* names
    }
  }
}

export function swizzle(expression: Expression, name: string, indices: number[]): Expression {
  const size = expression.ids.length
  if (size === 1 || indices.some((i) => i >= size))
    throw new WarpError(`${name}: ${sizeName(size)} has no such components.`)
  return new Expression(
    expression.compilation,
    indices.map((i) => expression.ids[i]!),
  )
}
