// Other names for operations, from three's TSL, p5.strands, p5 and GLSL: aliases, and compositions of existing operations.
import type { Expression } from './expression.js'
import { vectorMethods } from './vector-methods.js'

type Methods = Record<string, (...operands: unknown[]) => Expression>

/** Maps an alias → operation. */
export const aliases = {
  mul: 'mult',
  multiply: 'mult',
  times: 'mult',
  plus: 'add',
  minus: 'sub',
  subtract: 'sub',
  divide: 'div',
  negate: 'neg',
  modulo: 'mod',
  power: 'pow',
  inverseSqrt: 'inversesqrt',
  lerp: 'mix',
  constrain: 'clamp',
  mag: 'length',
  magnitude: 'length',
  normalized: 'normalize',
  fraction: 'fract',
  atan2: 'atan',
  lessThan: 'lt',
  lessThanEqual: 'le',
  lessEqual: 'le',
  greaterThan: 'gt',
  greaterThanEqual: 'ge',
  greaterEqual: 'ge',
  equal: 'eq',
  equals: 'eq',
  equalTo: 'eq',
  notEqual: 'ne',
  select: 'ifElse',
  perlin: 'noise',
} as const

/** Maps a name → a function that composes the operation from methods of its first operand. */
export const compositions: Readonly<
  Record<string, (x: Expression & Methods, ...others: unknown[]) => Expression>
> = {
  oneMinus: (x) => methodsOf(x.neg!()).add!(1),
  saturate: (x) => x.clamp!(0, 1),
  reciprocal: (x) => x.pow!(-1),
  pow2: (x) => x.mult!(x),
  pow3: (x) => methodsOf(x.mult!(x)).mult!(x),
  magSq: (x) => x.dot!(x),
  lengthSq: (x) => x.dot!(x),
  ...vectorMethods,
}

export const methodsOf = (expression: Expression) => expression as Expression & Methods

/** Maps an unknown method → what to write instead, for "did you mean". */
export const meantByMethods: Readonly<Record<string, string>> = {
  map: 'x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow)',
  smoothStep: 'glsl.smoothstep(low, high, x)',
  squareRoot: 'sqrt',
  sine: 'sin',
  cosine: 'cos',
  tangent: 'tan',
  absolute: 'abs',
  toFixed: 'round',
  set: 'v = glsl.vec3(x, y, z), since an expression never changes',
  setValue: 'v = glsl.vec3(x, y, z), since an expression never changes',
  getValue: 'v.x, v.y or v.z',
  setHeading: 'glsl.vec2(angle.cos(), angle.sin()).mult(v.length())',
  slerp: 'a.mix(b, amount), and .setMag(length) for its length',
  clampToZero: 'v.abs().lt(1e-6).ifElse(0, v)',
}

/** Maps an unknown function of `glsl` → what to write instead, for "did you mean". */
export const meantByFunctions: Readonly<Record<string, string>> = {
  time: 'millis, as in ({ glsl, millis }) => …',
  PI: 'Math.PI',
  vector: 'vec3',
  createVector: 'vec3',
  float: 'val',
  number: 'val',
}

/** The end of a message about an unknown name. */
export const operationLists = 'web/docs/operations.md lists them all.'
