// Operators on expressions. Numbers among numbers stay numbers, and JavaScript's own:
// `-1 % 3` is -1 there, while `x % 3` of an expression takes the sign of its divisor, as GLSL's mod.
import { isExpression } from '../errors/describe.js'
import { WarpError } from '../errors/errors.js'
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { Place } from '../options/place.js'
import { type ReadHelper, callsOf } from './calls.js'
import { noteOnce, noteReadOnce, sayingSo } from './messages.js'
import {
  type Glsl,
  decidesByVertex,
  isCondition,
  isWarped,
  useCondition,
  wholeOf,
} from './values.js'

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

/** What expressions know by another name. */
const named: Record<string, string> = { looseEq: 'eq', looseNe: 'ne' }

/** Operators on whole numbers of 32 bits, of which people know `x | 0` and `x >> 0`, which cut off the fraction. */
const bits: Record<string, (a: number, b: number) => number> = {
  '|': (a, b) => a | b,
  '&': (a, b) => a & b,
  '^': (a, b) => a ^ b,
  '<<': (a, b) => a << b,
  '>>': (a, b) => a >> b,
  '>>>': (a, b) => a >>> b,
}

/** Returns whether a comparison asks if a value is there at all, which JavaScript decides. */
const isNothing = (name: string, ...operands: unknown[]) =>
  /eq$|ne$/i.test(name) && operands.some((each) => each === null || each === undefined)

const noteEffect = (effect: string) =>
  noteOnce(
    `${effect} stands in an if that is decided for each vertex, on the GPU, so it is called once, in any case, while the warp is made; set a variable there, or let JavaScript decide the if by numbers.`,
  )

export type Operators = ReturnType<typeof operatorsOf>

/**
 * The operators for one run of an offset function. With `isPlain` a number has no truth of its own: `sum ? sum.add(x) : x` asks
 * whether there is one, as it does without operators.
 */
export function operatorsOf(glsl: Glsl, { read, isPlain }: RunOptions = {}) {
  const differs = isPlain ? isCondition : decidesByVertex
  const whole = (value: unknown) => wholeOf(glsl, value)
  const binary = (name: string) => (a: unknown, b: unknown) =>
    (isWarped(a) || isWarped(b)) && !isNothing(name, a, b)
      ? glsl[named[name] ?? name]!(whole(a), whole(b))
      : symbols[name]!(a as never, b as never)

  const and = (a: unknown, b: unknown) => {
    if (b === true) return a
    if (b === false) return dropCondition(a, false)
    return isCondition(a) && isCondition(b) ? glsl.and!(a, b) : glsl.ifElse!(a, whole(b), 0)
  }
  const or = (a: unknown, b: unknown) => {
    if (b === false) return a
    if (b === true) return dropCondition(a, true)
    if (isCondition(a) && isCondition(b)) return glsl.or!(a, b)
    return glsl.ifElse!(a, isCondition(a) ? 1 : a, whole(b))
  }
  /** One of two values by a condition, which JavaScript's true and false may be, too. */
  const select = (condition: unknown, yes: unknown, no: unknown) => {
    if (yes === no) return dropCondition(condition, yes)
    if (yes === true) return or(condition, no)
    if (no === false) return and(condition, yes)
    if (yes === false) return and(glsl.not!(condition), no)
    if (no === true) return or(glsl.not!(condition), yes)
    return glsl.ifElse!(condition, whole(yes), whole(no))
  }
  const dropCondition = (condition: unknown, value: unknown) => {
    useCondition(condition)
    return value
  }
  /** One of two values; the second is computed with variables as they were before the first. */
  const choose = (
    condition: unknown,
    yes: Thunk,
    no: Thunk,
    get?: () => unknown[],
    set?: (all: unknown[]) => void,
  ) => {
    if (!differs(condition)) return condition ? yes() : no()
    const before = get?.()
    const first = yes()
    if (before) set!(before)
    const second = no()
    if ((first === undefined) !== (second === undefined))
      throw new WarpError(
        'An if that is decided for each vertex returns something in one of its ways only; let the other return something too, such as return [0, 0, 0] at the end.',
      )
    return select(condition, first, second)
  }
  /** `choose` where a function returns early: the ways call `rest` for what comes after them. */
  const returning = (
    condition: unknown,
    yes: (rest: Thunk) => unknown,
    no: (rest: Thunk) => unknown,
    get?: () => unknown[],
    set?: (all: unknown[]) => void,
    rest: Thunk = () => undefined,
  ) =>
    choose(
      condition,
      () => yes(rest),
      () => no(rest),
      get,
      set,
    )
  const move = (x: unknown, by: number) =>
    isWarped(x) ? glsl.add!(whole(x), by) : typeof x === 'bigint' ? x + BigInt(by) : Number(x) + by

  const { call, method, invoke, construct } = callsOf(glsl, (make) => make(all), read)

  const all = {
    ...(Object.fromEntries(Object.keys(symbols).map((name) => [name, binary(name)])) as Record<
      string,
      (a: unknown, b: unknown) => unknown
    >),
    whole,
    choose,
    returning,
    call,
    method,
    invoke,
    construct,
    neg: (x: unknown) => (isWarped(x) ? glsl.neg!(whole(x)) : -(x as number)),
    plus: (x: unknown) => (isWarped(x) ? whole(x) : +(x as number)),
    not: (x: unknown) => (differs(x) ? glsl.not!(x) : !x),
    /** `~x`: of an expression only `~~x` is known, which the translation writes as `x | 0`. */
    bits(name: string, a: unknown, b: unknown) {
      if (!isWarped(a) && !isWarped(b)) return bits[name]!(a as number, b as number)
      if (b === 0 && /^(\||>>|\^)$/.test(name)) return glsl.trunc!(whole(a))
      throw new WarpError(
        `${name} works on the bits of whole numbers, not on expressions of a warp; write glsl.floor(x), x * 2 or x % 2.`,
      )
    },
    and: (a: unknown, b: Thunk) => (differs(a) ? and(a, b()) : a && b()),
    or: (a: unknown, b: Thunk) => (differs(a) ? or(a, b()) : a || b()),
    /** `++` and `--`. */
    move,
    /** The first of two, as what `x++` gives. */
    first: (x: unknown, _then: unknown) => (isWarped(x) || typeof x === 'bigint' ? x : Number(x)),
    /** `object[key] += 1`, where what stands for object and key must not be computed twice. */
    change: (object: Record<PropertyKey, unknown>, key: string, to: (value: unknown) => unknown) =>
      (object[key] = to(object[key])),
    /** `object[key]++`, which gives the value before. */
    changeAfter(
      object: Record<PropertyKey, unknown>,
      key: string,
      to: (value: unknown) => unknown,
    ) {
      const before = object[key]
      object[key] = to(before)
      return all.first(before, undefined)
    },
    /** The value of a call that nobody takes: of a p5.Vector it would change that vector. */
    unused(value: unknown, text: string) {
      if (isExpression(value))
        noteOnce(
          `${text} changes nothing: an expression always stays what it is, unlike a p5.Vector; set the variable, as in v = v.mult(2).`,
        )
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
      if (!differs(condition)) {
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
      if (after.every((value, i) => value === otherwise[i])) useCondition(condition)
      set(
        after.map((value, i) =>
          value === otherwise[i] ? value : select(condition, value, otherwise[i]),
        ),
      )
    },
    /** A condition that JavaScript itself must decide. */
    decided(condition: unknown, what: string) {
      if (differs(condition))
        throw new WarpError(
          `${what} cannot wait for a condition that differs by vertex; let a loop have a known count, and choose by ?: or by if and else that set variables.`,
        )
      return condition
    },
  }
  return all
}

/** Functions that need no translation any more. */
export const translated = new WeakSet<object>()

interface RunOptions {
  /** Reads helper functions; at build time they are translated beside the offset function. */
  read?: ReadHelper
  /** Variables that change, but are read once. */
  once?: readonly string[]
  /** True if the function uses no operators on numbers; see `operatorsOf`. */
  isPlain?: boolean
  /** Throws if the function cannot be called with this `this`. */
  check?: (self: unknown) => void
}

let current: Operators | undefined

/** The offset function that a translated text makes. */
export function withOperators(
  make: (operators: Operators) => (inputs: WarpInputs) => unknown,
  { read, once = [], isPlain = false, check }: RunOptions = {},
): OffsetFunction {
  const run = function (this: unknown, inputs: WarpInputs) {
    check?.(this)
    for (const name of once) noteReadOnce(new Place('createWarp'), name)
    const outer = current
    current = operatorsOf(glslOf(inputs), { ...(read && { read }), isPlain })
    try {
      return asVector(current, inputs, Reflect.apply(make(current), this, [inputs]))
    } finally {
      current = outer
    }
  } as OffsetFunction
  const result = read ? run : sayingSo(run, () => notTranslated)
  translated.add(result)
  return result
}

const notTranslated =
  'createWarp: an operator or a function of numbers meets an expression in a function that warpjet/operators/plugin has not translated. It translates functions that are handed to createWarp or compileWarp, and the functions of the same module that these call: move the function into that module, or write x.add(1), x.mult(2), x.sin() in it.'

let plain: Operators | undefined

/** The operators of the offset function that is running, for helper functions that a build has translated. */
export const operators: Operators = new Proxy({} as Operators, {
  get: (_, name) => Reflect.get(current ?? (plain ??= operatorsOf(noGlsl)), name) as unknown,
})

/** While no offset function is running. */
const noGlsl = new Proxy({} as Glsl, {
  get() {
    throw new WarpError(
      'An expression is used after the function that made it was over; use expressions only inside of it.',
    )
  },
})

/** An offset function gets the builder among its inputs, and the function of `compile` gets it alone. */
export const glslOf = (inputs: object) => ('glsl' in inputs ? inputs.glsl : inputs) as Glsl

/** Converts a result `[x, y, z]`, or a vector of p5, to a vec3. */
export function asVector(operators: Operators, inputs: object, place: unknown): Vec3 {
  const isOfVertex = 'glsl' in inputs && (!Array.isArray(place) || place.length === 3)
  return (isOfVertex && !isExpression(place) ? operators.whole(place) : place) as Vec3
}
