// What operators mean where an expression is among their operands; numbers among numbers stay numbers,
// and JavaScript's own: `-1 % 3` is -1 there, while `x % 3` of an expression takes the sign of its divisor, as GLSL's mod.
import { isExpression } from '../checks/describe.js'
import { WarpError } from '../checks/errors.js'
import type { OffsetFunction, Vec3, WarpInputs } from '../types/types.js'

type Glsl = Record<string, (...operands: unknown[]) => unknown>
type Thunk = () => unknown

const symbols: Record<string, (a: never, b: never) => unknown> = {
  add: (a: number, b: number) => a + b,
  sub: (a: number, b: number) => a - b,
  mult: (a: number, b: number) => a * b,
  div: (a: number, b: number) => a / b,
  mod: (a: number, b: number) => a % b,
  pow: (a: number, b: number) => a ** b,
  lt: (a: number, b: number) => a < b,
  le: (a: number, b: number) => a <= b,
  gt: (a: number, b: number) => a > b,
  ge: (a: number, b: number) => a >= b,
  eq: (a: unknown, b: unknown) => a === b,
  ne: (a: unknown, b: unknown) => a !== b,
  looseEq: (a: unknown, b: unknown) => a == b,
  looseNe: (a: unknown, b: unknown) => a != b,
}

/** Of p5 and Math, by what they are of expressions; others have one name. */
const functions: Record<string, (glsl: Glsl, ...x: unknown[]) => unknown> = {
  atan2: (glsl, y, x) => glsl.atan!(y, x),
  hypot: (glsl, ...x) => glsl.length!(glsl[`vec${x.length}`]!(...x)),
  lerp: (glsl, a, b, t) => glsl.mix!(a, b, t),
  constrain: (glsl, x, low, high) => glsl.clamp!(x, low, high),
  sq: (glsl, x) => glsl.mult!(x, x),
  mag: (glsl, ...x) => glsl.length!(glsl[`vec${x.length}`]!(...x)),
  cbrt: (glsl, x) => glsl.mult!(glsl.sign!(x), glsl.pow!(glsl.abs!(x), 1 / 3)),
  map: (glsl, x, a, b, c, d) =>
    glsl.add!(glsl.mult!(glsl.div!(glsl.sub!(x, a), glsl.sub!(b, a)), glsl.sub!(d, c)), c),
}

/** The names that `call` knows. */
export const functionNames = new Set([
  ...Object.keys(functions),
  ...'sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh abs sign floor ceil round trunc sqrt pow exp log log2 min max fract degrees radians'.split(
    ' ',
  ),
])

/** What expressions know by another name. */
const named: Record<string, string> = { looseEq: 'eq', looseNe: 'ne' }

/** Whether a value is there at all, JavaScript says. */
const isNothing = (name: string, ...operands: unknown[]) =>
  /eq$|ne$/i.test(name) && operands.some((each) => each === null || each === undefined)

/** So that no note comes of it: what is to be said is said here. */
const decidesNothing = (condition: unknown) =>
  (condition as { session: { use(condition: unknown): void } }).session.use(condition)

const noted = new Set<string>()

/** Once for each text. */
function noteEffect(effect: string) {
  if (noted.has(effect)) return
  noted.add(effect)
  console.warn(
    `${effect} stands in an if that is decided for each vertex, on the GPU, so it is called once, in any case, while the warp is made; set a variable there, or let JavaScript decide the if by numbers.`,
  )
}

export type Operators = ReturnType<typeof operatorsOf>

export function operatorsOf(glsl: Glsl) {
  const isWarped = (value: unknown): boolean =>
    isExpression(value) || (Array.isArray(value) && value.some(isWarped))
  /** An array of expressions is a vector. */
  const whole = (value: unknown): unknown =>
    Array.isArray(value) && value.length >= 2 && value.length <= 4
      ? glsl[`vec${value.length}`]!(...value)
      : value
  const binary = (name: string) => (a: unknown, b: unknown) =>
    (isWarped(a) || isWarped(b)) && !isNothing(name, a, b)
      ? glsl[named[name] ?? name]!(whole(a), whole(b))
      : symbols[name]!(a as never, b as never)
  /** One of two values; the second is computed with variables as they were before the first. */
  const choose = (
    condition: unknown,
    yes: Thunk,
    no: Thunk,
    get?: () => unknown[],
    set?: (all: unknown[]) => void,
  ) => {
    if (!isExpression(condition)) return condition ? yes() : no()
    const before = get?.()
    const first = whole(yes())
    if (before) set!(before)
    const second = whole(no())
    if ((first === undefined) !== (second === undefined))
      throw new WarpError(
        'An if that is decided for each vertex returns something in one of its ways only; let the other return something too, such as return [0, 0, 0] at the end.',
      )
    if (first === undefined) {
      decidesNothing(condition)
      return undefined
    }
    return glsl.ifElse!(condition, first, second)
  }

  return {
    ...(Object.fromEntries(Object.keys(symbols).map((name) => [name, binary(name)])) as Record<
      string,
      (a: unknown, b: unknown) => unknown
    >),
    whole,
    choose,
    neg: (x: unknown) => (isWarped(x) ? glsl.neg!(whole(x)) : -(x as number)),
    plus: (x: unknown) => (isWarped(x) ? x : +(x as number)),
    not: (x: unknown) => (isExpression(x) ? glsl.not!(x) : !x),
    and: (a: unknown, b: Thunk) => (isExpression(a) ? glsl.and!(a, b()) : a && b()),
    or: (a: unknown, b: Thunk) => (isExpression(a) ? glsl.or!(a, b()) : a || b()),
    /** `object[key] += 1`, where what stands for object and key must not be computed twice. */
    change: (object: Record<PropertyKey, unknown>, key: string, to: (value: unknown) => unknown) =>
      (object[key] = to(object[key])),
    call(name: string, known: (...x: unknown[]) => unknown, ...x: unknown[]) {
      if (!x.some(isWarped)) return known(...x)
      const own = functions[name]
      const operands = x.map(whole)
      if (own) return own(glsl, ...operands)
      return /^m(in|ax)$/.test(name)
        ? operands.reduce((a, b) => glsl[name]!(a, b))
        : glsl[name]!(...operands)
    },
    /** Both branches of an `if`, and what each leaves in the variables that either sets. */
    branch(
      condition: unknown,
      yes: Thunk,
      no: Thunk,
      get: () => unknown[],
      set: (all: unknown[]) => void,
      effect?: string,
    ) {
      if (!isExpression(condition)) {
        if (condition) yes()
        else no()
        return
      }
      if (effect) noteEffect(effect)
      const before = get()
      yes()
      const after = get()
      set(before)
      no()
      const otherwise = get()
      if (after.every((value, i) => value === otherwise[i])) decidesNothing(condition)
      set(
        after.map((value, i) =>
          value === otherwise[i]
            ? value
            : glsl.ifElse!(condition, whole(value), whole(otherwise[i])),
        ),
      )
    },
    /** A condition that JavaScript itself must decide. */
    decided(condition: unknown, what: string) {
      if (isExpression(condition))
        throw new WarpError(
          `${what} cannot wait for a condition that differs by vertex; let a loop have a known count, and choose by ?: or by if and else that set variables.`,
        )
      return condition
    },
  }
}

/** Functions that need no translation any more. */
export const translated = new WeakSet<object>()

/** The offset function that a translated text makes. */
export function withOperators(
  make: (operators: Operators) => (inputs: WarpInputs) => unknown,
): OffsetFunction {
  const result: OffsetFunction = (inputs) => {
    const operators = operatorsOf(inputs.glsl as unknown as Glsl)
    const place = make(operators)(inputs)
    const isOfVertex = Array.isArray(place) && place.length === 3
    return (isOfVertex ? operators.whole(place) : place) as Vec3
  }
  translated.add(result)
  return result
}
