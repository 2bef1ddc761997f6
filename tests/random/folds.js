// Generates random loops ("folds") for glsl.repeat, which can be evaluated as expressions and as plain numbers, with one to three states.
// The increment of each step is bounded, so that no state diverges.
import { randomOf } from './generate.js'

const unary = {
  sin: Math.sin,
  cos: Math.cos,
  tanh: Math.tanh,
  atan: Math.atan,
  abs: Math.abs,
}
const binary = {
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mult: (a, b) => a * b,
  min: Math.min,
  max: Math.max,
}

const pick = (random, list) => list[Math.floor(list.length * random())]

/** Generates a formula of numbers that reads variables by name. */
function grow(random, names, depth) {
  if (depth === 0)
    return random() < 0.2 ? Number((4 * random() - 2).toFixed(1)) : pick(random, names)
  if (random() < 0.4) return [pick(random, Object.keys(unary)), grow(random, names, depth - 1)]
  return [
    pick(random, Object.keys(binary)),
    grow(random, names, depth - 1),
    grow(random, names, Math.floor(depth * random())),
  ]
}

/** Evaluates a formula in plain numbers. */
function numberOf(formula, values) {
  if (typeof formula === 'number') return formula
  if (typeof formula === 'string') return values[formula]
  const [op, ...operands] = formula
  return (unary[op] ?? binary[op])(...operands.map((operand) => numberOf(operand, values)))
}

/** Builds a formula as an expression. */
function expressionOf(glsl, formula, values) {
  if (typeof formula === 'number') return glsl.val(formula)
  if (typeof formula === 'string') return values[formula]
  const [op, ...operands] = formula
  return glsl[op](...operands.map((operand) => expressionOf(glsl, operand, values)))
}

/**
 * Generates a loop of `steps` steps, whose body may contain an `inner` loop. Each loop has formulas for its states: `starts` for the
 * initial ones, `nexts` for those after each step. The formulas of the inner loop may read the outer states and step, too.
 */
function randomFold(random, outside, depth) {
  const level = depth === 0 ? 'inner' : 'outer'
  const states = Array.from({ length: 1 + Math.floor(3 * random()) }, (_, i) => `${level}${i}`)
  const step = `${level}Step`
  const variables = [...outside, ...states, step]
  const inner = depth > 0 && random() < 0.5 ? randomFold(random, variables, depth - 1) : undefined
  const readable = inner ? [...variables, ...inner.states.map((name) => `${name}End`)] : variables
  return {
    steps: Math.floor(6 * random()),
    states,
    step,
    starts: states.map(() => grow(random, outside, 2)),
    inner,
    // Half of the state, plus the sine of a formula, which is at most 1.
    nexts: states.map((name) => ['add', ['mult', name, 0.5], ['sin', grow(random, readable, 3)]]),
  }
}

const inputs = ['x', 'y', 'z']

export function randomFoldCase(seed) {
  const random = randomOf(31000 + seed)
  const fold = randomFold(random, inputs, 1)
  return { seed, inputs, fold, point: inputs.map(() => Math.fround(3 * random() - 1.5)) }
}

/** Runs a loop in plain numbers, which may read the values `outside` of it. Returns its final states. */
function runNumbers({ steps, states, step, starts, inner, nexts }, outside) {
  let now = starts.map((formula) => numberOf(formula, outside))
  for (let i = 0; i < steps; i++) {
    const values = { ...outside, [step]: i }
    states.forEach((name, k) => (values[name] = now[k]))
    if (inner)
      runNumbers(inner, values).forEach((end, k) => (values[`${inner.states[k]}End`] = end))
    now = nexts.map((formula) => numberOf(formula, values))
  }
  return now
}

/** Builds a loop as an expression, in the same way. */
function runExpressions(glsl, { steps, states, step, starts, inner, nexts }, outside) {
  const record = (list) => Object.fromEntries(list.map((state, i) => [states[i], state]))
  const ends = glsl.repeat(
    steps,
    record(starts.map((formula) => expressionOf(glsl, formula, outside))),
    (state, i) => {
      const values = { ...outside, ...state, [step]: i }
      if (inner)
        for (const [k, end] of runExpressions(glsl, inner, values).entries())
          values[`${inner.states[k]}End`] = end
      return record(nexts.map((formula) => expressionOf(glsl, formula, values)))
    },
  )
  return states.map((name) => ends[name])
}

/** Returns the sum of the final states, in double precision. */
export const foldNumber = ({ fold, inputs }, point) =>
  runNumbers(fold, Object.fromEntries(inputs.map((name, i) => [name, point[i]]))).reduce(
    (a, b) => a + b,
  )

/** Returns outputs for `compile`: the sum of the final states, its slopes by x, y and z, and its second derivative by x and y. */
export const foldCallback =
  ({ fold, inputs, seed }) =>
  (glsl) => {
    const values = Object.fromEntries(inputs.map((name) => [name, glsl.param(name)]))
    const sum = runExpressions(glsl, fold, values).reduce((a, b) => a.add(b))
    const byX = glsl.derivative(sum, values.x)
    return {
      [`value${seed}`]: sum,
      [`slope${seed}`]: glsl.vec3(
        byX,
        glsl.derivative(sum, values.y),
        glsl.derivative(sum, values.z),
      ),
      [`second${seed}`]: glsl.derivative(byX, values.y),
    }
  }

/** Returns the slopes by x, y and z from central differences in double precision; `isFirm` if those of two step sizes agree. */
export function slopes(test, point) {
  const at = (i, h) =>
    foldNumber(
      test,
      point.map((x, k) => (k === i ? x + h : x)),
    )
  return point.map((_, i) => {
    const [coarse, fine] = [1e-4, 1e-5].map((h) => (at(i, h) - at(i, -h)) / (2 * h))
    return { value: fine, isFirm: Math.abs(coarse - fine) < 1e-4 * Math.max(1, Math.abs(fine)) }
  })
}

/** Returns the second derivative with respect to x and y. */
export function secondSlope(test, [x, y, z]) {
  const at = (h, k) => foldNumber(test, [x + h, y + k, z])
  const [coarse, fine] = [2e-3, 1e-3].map(
    (h) => (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h),
  )
  return { value: fine, isFirm: Math.abs(coarse - fine) < 1e-3 * Math.max(1, Math.abs(fine)) }
}
