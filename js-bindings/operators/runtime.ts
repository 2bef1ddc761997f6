// Operators on expressions. If all operands are numbers, operators are JavaScript's: `-1 % 3` is -1, while `x % 3` on an expression has
// the sign of the divisor, like GLSL's mod.
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { isExpression } from '../errors/describe.js'
import { WarpError } from '../errors/errors.js'
import { Place } from '../options/place.js'
import { callsOf, type ReadHelper } from './calls.js'
import { noteOnce, noteReadOnce, withOperatorMessage } from './messages.js'
import {
  decidesByVertex,
  isCondition,
  isExpressionLike,
  toVector,
  useCondition,
  type Glsl,
} from './values.js'

type Thunk = () => unknown

/** JavaScript's operators, for operands of which none is an expression. */
const jsOperators: Record<string, (a: never, b: never) => unknown> = {
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

/** Maps operators to methods of expressions, where the names differ. */
const methodNames: Record<string, string> = { looseEq: 'eq', looseNe: 'ne' }

/** Operators on 32-bit integers; the common ones are `x | 0` and `x >> 0`, which truncate. */
const bits: Record<string, (a: number, b: number) => number> = {
  '|': (a, b) => a | b,
  '&': (a, b) => a & b,
  '^': (a, b) => a ^ b,
  '<<': (a, b) => a << b,
  '>>': (a, b) => a >> b,
  '>>>': (a, b) => a >>> b,
}

/** Returns whether a comparison tests if a value exists at all, which JavaScript decides. */
const isExistenceTest = (name: string, ...operands: unknown[]) =>
  /eq$|ne$/i.test(name) && operands.some((each) => each === null || each === undefined)

const warnAboutEffect = (effect: string) =>
  noteOnce(
    `${effect} is in an if that the GPU decides for each vertex, so it is always called once, while the warp is made; set a variable there, or let JavaScript decide the if by numbers.`,
  )

export type Operators = ReturnType<typeof operatorsOf>

/**
 * Returns the operators for one run of an offset function. If `isPlain`, a numeric expression as a condition only tests whether the
 * expression exists, as in an untranslated function: `sum ? sum.add(x) : x`.
 */
export function operatorsOf(glsl: Glsl, { readHelper, isPlain }: RunOptions = {}) {
  const differsByVertex = isPlain ? isCondition : decidesByVertex
  /** Converts arrays and p5's vectors to vectors of `glsl`; returns other values unchanged. */
  const asOperand = (value: unknown) => toVector(glsl, value)
  const binary = (name: string) => (a: unknown, b: unknown) =>
    (isExpressionLike(a) || isExpressionLike(b)) && !isExistenceTest(name, a, b)
      ? glsl[methodNames[name] ?? name]!(asOperand(a), asOperand(b))
      : jsOperators[name]!(a as never, b as never)

  const and = (a: unknown, b: unknown) => {
    if (b === true) return a
    if (b === false) return dropCondition(a, false)
    return isCondition(a) && isCondition(b) ? glsl.and!(a, b) : glsl.ifElse!(a, asOperand(b), 0)
  }
  const or = (a: unknown, b: unknown) => {
    if (b === false) return a
    if (b === true) return dropCondition(a, true)
    if (isCondition(a) && isCondition(b)) return glsl.or!(a, b)
    return glsl.ifElse!(a, isCondition(a) ? 1 : a, asOperand(b))
  }
  /** Selects one of two values, either of which may be JavaScript's true or false. */
  const select = (condition: unknown, yes: unknown, no: unknown) => {
    if (yes === no) return dropCondition(condition, yes)
    if (yes === true) return or(condition, no)
    if (no === false) return and(condition, yes)
    if (yes === false) return and(glsl.not!(condition), no)
    if (no === true) return or(glsl.not!(condition), yes)
    return glsl.ifElse!(condition, asOperand(yes), asOperand(no))
  }
  const dropCondition = (condition: unknown, value: unknown) => {
    useCondition(condition)
    return value
  }
  /** Selects one of two values; restores the variables before it computes the second. */
  const choose = (
    condition: unknown,
    yes: Thunk,
    no: Thunk,
    get?: () => unknown[],
    set?: (all: unknown[]) => void,
  ) => {
    if (!differsByVertex(condition)) return condition ? yes() : no()
    const before = get?.()
    const first = yes()
    if (before) set!(before)
    const second = no()
    if ((first === undefined) !== (second === undefined))
      throw new WarpError(
        'An if that is decided for each vertex returns a value in only one of its branches; let the other branch return a value too, such as return [0, 0, 0] at the end.',
      )
    return select(condition, first, second)
  }
  /** Does what `choose` does for an early return: the branches call `rest` to run the statements after the `if`. */
  const chooseReturn = (
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
    isExpressionLike(x)
      ? glsl.add!(asOperand(x), by)
      : typeof x === 'bigint'
        ? x + BigInt(by)
        : Number(x) + by

  const { call, method, invoke, construct } = callsOf(glsl, (make) => make(operators), readHelper)

  const operators = {
    ...(Object.fromEntries(Object.keys(jsOperators).map((name) => [name, binary(name)])) as Record<
      string,
      (a: unknown, b: unknown) => unknown
    >),
    asOperand,
    choose,
    returning: chooseReturn,
    call,
    method,
    invoke,
    construct,
    neg: (x: unknown) => (isExpressionLike(x) ? glsl.neg!(asOperand(x)) : -(x as number)),
    plus: (x: unknown) => (isExpressionLike(x) ? asOperand(x) : +(x as number)),
    not: (x: unknown) => (differsByVertex(x) ? glsl.not!(x) : !x),
    /** Bitwise operators. On expressions only truncation is supported: `x | 0`, also written `~~x`, which the translation converts. */
    bits(name: string, a: unknown, b: unknown) {
      if (!isExpressionLike(a) && !isExpressionLike(b)) return bits[name]!(a as number, b as number)
      if (b === 0 && /^(\||>>|\^)$/.test(name)) return glsl.trunc!(asOperand(a))
      throw new WarpError(
        `${name} works on the bits of whole numbers, not on expressions of a warp; write glsl.floor(x), x * 2 or x % 2.`,
      )
    },
    and: (a: unknown, b: Thunk) => (differsByVertex(a) ? and(a, b()) : a && b()),
    or: (a: unknown, b: Thunk) => (differsByVertex(a) ? or(a, b()) : a || b()),
    /** `++` and `--`. */
    move,
    /** Returns the first of two values, like `x++`. */
    first: (x: unknown, _then: unknown) =>
      isExpressionLike(x) || typeof x === 'bigint' ? x : Number(x),
    /** `object[key] += 1`, without evaluating object and key twice. */
    change: (object: Record<PropertyKey, unknown>, key: string, to: (value: unknown) => unknown) =>
      (object[key] = to(object[key])),
    /** `object[key]++`, which returns the old value. */
    changeAfter(
      object: Record<PropertyKey, unknown>,
      key: string,
      to: (value: unknown) => unknown,
    ) {
      const before = object[key]
      object[key] = to(before)
      return operators.first(before, undefined)
    },
    /** Warns about a call on an expression whose result is unused: the same call on a p5.Vector would change the vector. */
    unused(value: unknown, text: string) {
      if (isExpression(value))
        noteOnce(
          `${text} has no effect: an expression never changes, unlike a p5.Vector; set the variable, as in v = v.mult(2).`,
        )
    },
    /** Runs both branches of an `if`. For each variable that a branch sets, selects between its values after the two branches. */
    branch(
      condition: unknown,
      yes: Thunk,
      no: Thunk,
      get: () => unknown[],
      set: (all: unknown[]) => void,
      effect?: string,
    ) {
      if (!differsByVertex(condition)) {
        if (condition) yes()
        else no()
        return
      }
      if (effect) warnAboutEffect(effect)
      const before = get()
      yes()
      const ifTrue = get()
      set(before)
      no()
      const ifFalse = get()
      if (ifTrue.every((value, i) => value === ifFalse[i])) useCondition(condition)
      set(
        ifTrue.map((value, i) =>
          value === ifFalse[i] ? value : select(condition, value, ifFalse[i]),
        ),
      )
    },
    /** Returns a condition that JavaScript can decide; throws for one that differs by vertex. `what` is the statement, for the message. */
    decided(condition: unknown, what: string) {
      if (differsByVertex(condition))
        throw new WarpError(
          `${what} cannot depend on a condition that differs by vertex; use a loop with a known count, and choose by ?: or by if and else that set variables.`,
        )
      return condition
    },
  }
  return operators
}

/** Functions that are already translated. */
export const translated = new WeakSet<object>()

interface RunOptions {
  /** Translates helper functions. Missing in a build, which translates them together with the offset function. */
  readHelper?: ReadHelper
  /** Variables that are read only once although their values change. */
  once?: readonly string[]
  /** True if the function uses only logic (see needs.ts), so that a numeric condition tests for existence; see `operatorsOf`. */
  isPlain?: boolean
  /** Throws if the function cannot be called with this `this`. */
  check?: (self: unknown) => void
}

/** The operators of the running offset function. */
let runningOperators: Operators | undefined

/** Makes an offset function from the factory of a translated function. */
export function withOperators(
  make: (operators: Operators) => (inputs: WarpInputs) => unknown,
  { readHelper, once = [], isPlain = false, check }: RunOptions = {},
): OffsetFunction {
  const run = function (this: unknown, inputs: WarpInputs) {
    check?.(this)
    for (const name of once) noteReadOnce(new Place('createWarp'), name)
    const outer = runningOperators
    runningOperators = operatorsOf(glslOf(inputs), { ...(readHelper && { readHelper }), isPlain })
    try {
      return asVector(
        runningOperators,
        inputs,
        Reflect.apply(make(runningOperators), this, [inputs]),
      )
    } finally {
      runningOperators = outer
    }
  } as OffsetFunction
  const result = readHelper ? run : withOperatorMessage(run, () => notTranslated)
  translated.add(result)
  return result
}

const notTranslated =
  'createWarp: an operator or a function of numbers got an expression in a function that warpjet/operators/plugin has not translated. It translates functions that are passed to createWarp or compileWarp, and the functions of the same module that these call: move the function into that module, or write x.add(1), x.mult(2), x.sin() in it.'

/** The operators while no offset function is running. */
let idleOperators: Operators | undefined

/** The operators of the running offset function, for helper functions that a build has translated. */
export const operators: Operators = new Proxy({} as Operators, {
  get: (_, name) =>
    Reflect.get(runningOperators ?? (idleOperators ??= operatorsOf(noGlsl)), name) as unknown,
})

/** The builder while no offset function is running. */
const noGlsl = new Proxy({} as Glsl, {
  get() {
    throw new WarpError(
      'An expression is used after the function that made it has returned; use expressions only inside of it.',
    )
  },
})

/** Returns the builder, which is one of the inputs of an offset function, and the only argument of a function for `compile`. */
export const glslOf = (inputs: object) => ('glsl' in inputs ? inputs.glsl : inputs) as Glsl

/** Converts a result `[x, y, z]`, or a vector of p5, to a vec3. */
export function asVector(operators: Operators, inputs: object, result: unknown): Vec3 {
  const isOffset = 'glsl' in inputs && (!Array.isArray(result) || result.length === 3)
  return (isOffset && !isExpression(result) ? operators.asOperand(result) : result) as Vec3
}
