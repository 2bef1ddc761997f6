// The functions of Math, p5 and p5.strands that translated code may call with expressions.
import { WarpError } from '../errors/errors.js'
import { noteOnce } from './messages.js'
import { isVectorLike, toVector, type Glsl } from './values.js'

/** Computes a function of the expressions `x`; `pageFunction` is the page's function of the same name, if it has one. */
type Formula = (glsl: Glsl, x: unknown[], pageFunction?: PageFunction) => unknown
type PageFunction = (...x: unknown[]) => unknown

/** Functions with the same name in `glsl`. */
const sameInGlsl =
  'sinh cosh tanh asinh acosh atanh abs sign floor ceil trunc sqrt pow exp log log2 fract degrees radians'

/** Functions of p5.strands, which JavaScript and p5 1 lack: if no operand is an expression, `numberFunctions` compute the result. */
const strands =
  'clamp mix step smoothstep length normalize dot cross distance mod inversesqrt reflect vec2 vec3 vec4'

/** Functions that take an angle, and those that return one, each with an argument and its result under p5's `angleMode(DEGREES)`. */
const angleArguments: Record<string, readonly [x: number, inDegrees: number]> = {
  sin: [90, 1],
  cos: [180, -1],
  tan: [45, 1],
}
const angleResults: Record<string, readonly [x: number[], inDegrees: number]> = {
  asin: [[1], 90],
  acos: [[-1], 180],
  atan: [[1], 45],
  atan2: [[1, 1], 45],
}

const isNear = (value: unknown, expected: number) => Math.abs(Number(value) - expected) < 1e-6

/** Returns whether the page's function uses degrees. We call the function to find out, since p5 keeps the mode per sketch. */
const usesDegrees = (pageFunction: PageFunction | undefined, x: number[], inDegrees: number) =>
  !!pageFunction && isNear(pageFunction(...x), inDegrees)

const vector = (glsl: Glsl, x: unknown[]) => glsl[`vec${x.length}`]!(...x)

function lengthOf(glsl: Glsl, x: unknown[]): unknown {
  if (x.length === 1) return glsl.length!(x[0])
  if (x.length <= 4) return glsl.length!(vector(glsl, x))
  return glsl.sqrt!(x.map((each) => glsl.mult!(each, each)).reduce((a, b) => glsl.add!(a, b)))
}

function distance(glsl: Glsl, x: unknown[]): unknown {
  if (![2, 4, 6].includes(x.length))
    throw new WarpError(`dist: expected two vectors, or 4 or 6 numbers, got ${x.length} arguments.`)
  const half = x.length / 2
  const [a, b] = [x.slice(0, half), x.slice(half)]
  return half === 1 ? glsl.dist!(a[0], b[0]) : glsl.dist!(vector(glsl, a), vector(glsl, b))
}

/** Rounds halves up, like JavaScript. Comparing the fraction is exact, whereas x + 0.5 rounds. */
function round(glsl: Glsl, [x, digits = 0]: unknown[]): unknown {
  if (digits !== 0) {
    if (typeof digits !== 'number')
      throw new WarpError('round: expected a number of decimals, got an expression.')
    const power = 10 ** digits
    return glsl.div!(round(glsl, [glsl.mult!(x, power)]), power)
  }
  const low = glsl.floor!(x)
  return glsl.add!(low, glsl.step!(0.5, glsl.sub!(x, low)))
}

function map(glsl: Glsl, [x, a, b, c, d, isClamped]: unknown[]): unknown {
  const fraction = glsl.div!(glsl.sub!(x, a), glsl.sub!(b, a))
  const mapped = glsl.add!(glsl.mult!(fraction, glsl.sub!(d, c)), c)
  return isClamped ? glsl.clamp!(mapped, glsl.min!(c, d), glsl.max!(c, d)) : mapped
}

/** Replaces p5's noise, a table of random numbers that no shader has, by ours, with the same range and four octaves. */
function noise(glsl: Glsl, x: unknown[]): unknown {
  noteOnce(
    "noise: p5's noise() works on numbers; for expressions it becomes warpjet's glsl.fbm(p, { octaves: 4 }) * 0.5 + 0.5, which has the same range and another pattern. Write that to choose another noise, such as glsl.simplex(p).",
  )
  const point = x.length === 1 ? x[0] : vector(glsl, x)
  return glsl.add!(glsl.mult!(glsl.fbm!(point, { octaves: 4 }), 0.5), 0.5)
}

/** `min` and `max` of any number of operands, or of p5's single array. */
const minOrMax =
  (name: 'min' | 'max'): Formula =>
  (glsl, x) =>
    (x.length === 1 && Array.isArray(x[0]) ? (x[0] as unknown[]) : x)
      .map((each) => toVector(glsl, each))
      .reduce((a, b) => glsl[name]!(a, b))

const withAngleArgument =
  (name: string): Formula =>
  (glsl, [x], pageFunction) =>
    glsl[name]!(
      usesDegrees(pageFunction, [angleArguments[name]![0]], angleArguments[name]![1])
        ? glsl.radians!(x)
        : x,
    )

const withAngleResult =
  (name: string): Formula =>
  (glsl, x, pageFunction) => {
    const angle = glsl[name === 'atan2' ? 'atan' : name]!(...x)
    return usesDegrees(pageFunction, ...angleResults[name]!) ? glsl.degrees!(angle) : angle
  }

const formulasFor = (names: string) =>
  Object.fromEntries(
    names.split(' ').map((name): [string, Formula] => [name, (glsl, x) => glsl[name]!(...x)]),
  )

export const formulas: Readonly<Record<string, Formula>> = {
  ...formulasFor(sameInGlsl),
  ...formulasFor(strands),
  ...Object.fromEntries(Object.keys(angleArguments).map((name) => [name, withAngleArgument(name)])),
  ...Object.fromEntries(Object.keys(angleResults).map((name) => [name, withAngleResult(name)])),
  min: minOrMax('min'),
  max: minOrMax('max'),
  hypot: lengthOf,
  mag: lengthOf,
  length: lengthOf,
  distance,
  dist: distance,
  round,
  map,
  noise,
  lerp: (glsl, [a, b, t]) => glsl.mix!(a, b, t),
  constrain: (glsl, [x, low, high]) => glsl.clamp!(x, low, high),
  norm: (glsl, [x, a, b]) => glsl.div!(glsl.sub!(x, a), glsl.sub!(b, a)),
  sq: (glsl, [x]) => glsl.mult!(x, x),
  cbrt: (glsl, [x]) => glsl.mult!(glsl.sign!(x), glsl.pow!(glsl.abs!(x), 1 / 3)),
  log10: (glsl, [x]) => glsl.div!(glsl.log!(x), Math.LN10),
  log1p: (glsl, [x]) => glsl.log!(glsl.add!(x, 1)),
  expm1: (glsl, [x]) => glsl.sub!(glsl.exp!(x), 1),
  fround: (_, [x]) => x,
  createVector: (glsl, [x = 0, y = 0, z = 0]) => glsl.vec3!(x, y, z),
}

/** Functions for which an array is a list of operands rather than a vector. */
const listFunctions = new Set(['min', 'max'])

export const isKnown = (name: string) => Object.hasOwn(formulas, name)

/** Calls a known function with operands of which at least one is an expression. */
export const callOnExpressions = (
  glsl: Glsl,
  name: string,
  x: unknown[],
  pageFunction?: PageFunction,
) =>
  formulas[name]!(
    glsl,
    listFunctions.has(name) ? x : x.map((each) => toVector(glsl, each)),
    pageFunction,
  )

const strandsNames = new Set(strands.split(' '))

/**
 * Calls a known function if no operand is an expression. A function in `numberFunctions` with numbers is computed there; other functions
 * are the page's. We never call the page's functions of p5.strands, since those of p5 2 throw outside of a shader.
 */
export function callOnNumbers(
  glsl: Glsl | undefined,
  name: string,
  x: unknown[],
  pageFunction?: PageFunction,
) {
  const ours = numberFunctions[name]
  if (ours && x.every((each) => typeof each === 'number')) return ours(...(x as number[]))
  if (pageFunction && !strandsNames.has(name)) return pageFunction(...x)
  if (glsl && (strandsNames.has(name) || x.some(isVectorLike)))
    return callOnExpressions(glsl, name, x)
  throw new ReferenceError(`${name} is not defined`)
}

const clamp = (x: number, low: number, high: number) => Math.min(Math.max(x, low), high)

const numberFunctions: Record<string, (...x: number[]) => number> = {
  clamp: (x, low, high) => clamp(x!, low!, high!),
  mix: (a, b, t) => a! * (1 - t!) + b! * t!,
  step: (edge, x) => (x! < edge! ? 0 : 1),
  smoothstep(low, high, x) {
    const t = clamp((x! - low!) / (high! - low!), 0, 1)
    return t * t * (3 - 2 * t)
  },
  length: (x) => Math.abs(x!),
  mod: (x, y) => x! - y! * Math.floor(x! / y!),
  inversesqrt: (x) => 1 / Math.sqrt(x!),
}
