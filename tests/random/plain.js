// Computes each operation in double precision: written from chapter 8 of the GLSL ES 3.00 specification and from the
// conventions of web/docs/derivatives.md, independently of the compiler's table.
import { dimension, isMatrix } from './shapes.js'

const toNumber = (condition) => (condition ? 1 : 0)
const clampTo = (x, low, high) => Math.min(Math.max(x, low), high)

/** Rounds to the nearest integer; a half to the even one. */
function roundToEven(x) {
  const below = Math.floor(x)
  if (x - below !== 0.5) return Math.round(x)
  return below % 2 === 0 ? below : below + 1
}

function smoothstep(low, high, x) {
  const t = clampTo((x - low) / (high - low), 0, 1)
  return t * t * (3 - 2 * t)
}

/** Operations on numbers, and on vectors by component. */
export const byComponent = {
  neg: (x) => -x,
  add: (x, y) => x + y,
  sub: (x, y) => x - y,
  mult: (x, y) => x * y,
  div: (x, y) => x / y,
  pow: Math.pow,
  sqrt: Math.sqrt,
  inversesqrt: (x) => 1 / Math.sqrt(x),
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  asin: Math.asin,
  acos: Math.acos,
  atan: (y, x) => (x === undefined ? Math.atan(y) : Math.atan2(y, x)),
  sinh: Math.sinh,
  cosh: Math.cosh,
  tanh: Math.tanh,
  asinh: Math.asinh,
  acosh: Math.acosh,
  atanh: Math.atanh,
  exp: Math.exp,
  exp2: (x) => 2 ** x,
  log: Math.log,
  log2: Math.log2,
  abs: Math.abs,
  sign: Math.sign,
  floor: Math.floor,
  ceil: Math.ceil,
  round: roundToEven,
  trunc: Math.trunc,
  fract: (x) => x - Math.floor(x),
  mod: (x, y) => x - y * Math.floor(x / y),
  min: (x, y) => Math.min(x, y),
  max: (x, y) => Math.max(x, y),
  clamp: clampTo,
  mix: (x, y, t) => x * (1 - t) + y * t,
  step: (edge, x) => toNumber(x >= edge),
  smoothstep,
  radians: (x) => (x * Math.PI) / 180,
  degrees: (x) => (x * 180) / Math.PI,
  lt: (x, y) => toNumber(x < y),
  le: (x, y) => toNumber(x <= y),
  gt: (x, y) => toNumber(x > y),
  ge: (x, y) => toNumber(x >= y),
  eq: (x, y) => toNumber(x === y),
  ne: (x, y) => toNumber(x !== y),
  and: (a, b) => toNumber(a && b),
  or: (a, b) => toNumber(a || b),
  not: (a) => toNumber(!a),
  ifElse: (condition, yes, no) => (condition ? yes : no),
}
const aliases = {
  sum: 'add',
  prod: 'mult',
  vecSum: 'add',
  vecProd: 'mult',
  vecMix: 'mix',
  vecClamp: 'clamp',
  vecMin: 'min',
  vecMax: 'max',
  vecIfElse: 'ifElse',
}
for (const [alias, name] of Object.entries(aliases)) byComponent[alias] = byComponent[name]

/** Operations with any number of operands, from left to right. */
export const chained = new Set(['add', 'sub', 'mult', 'div', 'min', 'max', 'and', 'or', 'sum'])
for (const name of ['prod', 'vecSum', 'vecProd', 'vecMin', 'vecMax']) chained.add(name)

const times = (v, factor) => v.map((x) => x * factor)
const minus = (v, w) => v.map((x, i) => x - w[i])
const plus = (v, w) => v.map((x, i) => x + w[i])
const dot = (v, w) => v.reduce((sum, x, i) => sum + x * w[i], 0)
const length = (v) => Math.sqrt(dot(v, v))
const normalize = (v) => (length(v) ? times(v, 1 / length(v)) : v)

function refract(incident, normal, [eta]) {
  const along = dot(normal, incident)
  const k = 1 - eta * eta * (1 - along * along)
  if (k < 0) return times(incident, 0)
  return minus(times(incident, eta), times(normal, eta * along + Math.sqrt(k)))
}

const ranges = Array.from({ length: 17 }, (_, count) => Array.from({ length: count }, (_, i) => i))
const range = (count) => ranges[count]
const column = (m, i, n = Math.sqrt(m.length)) => m.slice(i * n, i * n + n)
const row = (m, i, n = Math.sqrt(m.length)) => range(n).map((j) => m[j * n + i])
const transpose = (m) => range(Math.sqrt(m.length)).flatMap((i) => row(m, i))
const timesVector = (m, v) => v.map((_, i) => dot(row(m, i), v))
const timesMatrix = (m, k) =>
  range(Math.sqrt(k.length)).flatMap((i) => timesVector(m, column(k, i)))

/** Returns the matrix without a column and a row. */
const minor = (m, j, i) => {
  const n = Math.sqrt(m.length)
  return m.filter((_, place) => Math.floor(place / n) !== j && place % n !== i)
}
const cofactor = (m, j, i) => (-1) ** (i + j) * determinant(minor(m, j, i))
const determinant = (m) =>
  m.length < 2 ? (m[0] ?? 1) : column(m, 0).reduce((sum, x, i) => sum + x * cofactor(m, 0, i), 0)
function inverse(m) {
  const n = Math.sqrt(m.length)
  const divisor = determinant(m)
  return range(n).flatMap((j) => range(n).map((i) => cofactor(m, i, j) / divisor))
}

/** Computes a rotation by Rodrigues' formula: v cos + (axis × v) sin + axis (axis · v) (1 - cos), for each column of the identity. */
function rotation(axis, s, c) {
  const unit = normalize(axis)
  return [0, 1, 2].flatMap((i) => {
    const e = [0, 1, 2].map((j) => toNumber(i === j))
    return plus(plus(times(e, c), times(cross(unit, e), s)), times(unit, unit[i] * (1 - c)))
  })
}

/** Returns the operations that use sine and cosine, with any two functions instead of these. */
export function rotationFrom(sin, cos) {
  const rotate = (axis, [angle]) => rotation(axis, sin(angle), cos(angle))
  return {
    sin,
    cos,
    tan: (x) => sin(x) / cos(x),
    rotate,
    rotateX: (angle) => rotate([1, 0, 0], angle),
    rotateY: (angle) => rotate([0, 1, 0], angle),
    rotateZ: (angle) => rotate([0, 0, 1], angle),
  }
}

function cross([a, b, c], [x, y, z]) {
  return [b * z - c * y, c * x - a * z, a * y - b * x]
}

const { rotate, rotateX, rotateY, rotateZ } = rotationFrom(Math.sin, Math.cos)

/** Operations on whole vectors and matrices. */
export const structural = {
  scale: (v, [factor]) => times(v, factor),
  dot: (v, w) => [dot(v, w)],
  length: (v) => [length(v)],
  dist: (v, w) => [length(minus(v, w))],
  distance: (v, w) => [length(minus(v, w))],
  cross,
  normalize,
  reflect: (v, normal) => minus(v, times(normal, 2 * dot(normal, v))),
  refract,
  faceforward: (normal, v, reference) => times(normal, dot(reference, v) < 0 ? 1 : -1),
  transpose,
  determinant: (m) => [determinant(m)],
  inverse,
  rotate,
  rotateX,
  rotateY,
  rotateZ,
}

const matrixProduct = (m, k, shapeM, shapeK) => {
  if (!isMatrix(shapeK)) return dimension(shapeK) === 1 ? times(m, k[0]) : timesVector(m, k)
  return isMatrix(shapeM) ? timesMatrix(m, k) : timesVector(transpose(k), m)
}

/** Constructs a vector or a matrix, by columns or by rows, from its components. */
function construct(name, size, components) {
  const numbers = components.flat()
  if (numbers.length > 1) return name.endsWith('Rows') ? transpose(numbers) : numbers
  const n = dimension(name)
  return range(size).map((i) => (isMatrix(name) && i % (n + 1) ? 0 : numbers[0]))
}

/** Operations by name; another table may replace some of them. */
export const plainOperations = { ...byComponent, ...structural }

const letters = ['xyzw', 'rgba', 'stpq']
export const letterIndex = (letter) => Math.max(...letters.map((set) => set.indexOf(letter)))

/** Returns the value of one node of an expression (see ast.js) from the values of its arguments. */
export function apply(node, values, operations = plainOperations) {
  const { op, args, size } = node
  if (op === 'swizzle') return [...node.letters].map((letter) => values[0][letterIndex(letter)])
  if (op === 'column') return column(values[0], node.index)
  if (op === 'row') return row(values[0], node.index)
  if (/^(vec|mat)\d/.test(op)) return construct(op, size, values)
  if (op === 'mult' && args.some(({ shape }) => isMatrix(shape)))
    return matrixProduct(...values, ...args.map(({ shape }) => shape))
  const operation = operations[op]
  if (structural[op]) return operation(...values)
  const isChain = chained.has(op) && values.length > 2
  const operate = isChain ? (first, ...others) => others.reduce(fold(operation), first) : operation
  const [a, b, c, ...more] = values
  const part = (value, i) => value?.[value.length === 1 ? 0 : i]
  return range(size).map((i) =>
    operate(part(a, i), part(b, i), part(c, i), ...more.map((value) => part(value, i))),
  )
}
const fold = (operation) => (sum, operand) => operation(sum, operand)
