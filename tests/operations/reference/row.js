// Helpers for the rows of the reference: domains to sample, and operations by component.

/** Returns a number of either sign whose magnitude is from 10⁻⁴ to 0.1, distributed evenly on a logarithmic scale. */
export const smallNumber = (random) => (random() < 0.5 ? -1 : 1) * 10 ** -(1 + 3 * random())

export const pick = (list, random) => list[Math.floor(list.length * random())]

/**
 * Makes a domain: a function that draws a number between `from` and `to` from a random source. One in twelve numbers is one of `at`, two in
 * ten are close to one of `near`, which are kinks or ends of the domain.
 */
export const span =
  (from, to, { at = [], near = at } = {}) =>
  (random) => {
    const chance = random()
    if (at.length && chance < 0.08) return pick(at, random)
    const nearby = near.length && chance < 0.3 ? pick(near, random) + smallNumber(random) : NaN
    return nearby >= from && nearby <= to ? nearby : from + (to - from) * random()
  }

/** Makes a domain of numbers of either sign, at least `min` and at most `max` from zero. */
export const awayFromZero = (min, max) => (random) =>
  (random() < 0.5 ? -1 : 1) * (min + (max - min) * random())

/** Returns the integers from -`max` to `max`. */
export const integersUpTo = (max) => Array.from({ length: 2 * max + 1 }, (_, i) => i - max)
/** Returns these integers plus 0.5. */
export const halves = (max) => integersUpTo(max).map((n) => n + 0.5)

/** For `adjust`: brings some components of the other operands close to, or exactly to, those of the first. */
export const makeOperandsMeet = (operands, random) =>
  operands.map((operand, k) =>
    operand.map((x, c) => {
      const chance = k === 0 ? 1 : random()
      if (chance > 0.3) return x
      return operands[0][c % operands[0].length] + (chance < 0.07 ? 0 : smallNumber(random))
    }),
  )

/** Applies a function of numbers to vectors by component; a number applies to each component. */
export const byComponent =
  (f) =>
  (...operands) => {
    const longestOperand = operands.reduce((longest, operand) =>
      operand.length > longest.length ? operand : longest,
    )
    return longestOperand.map((_, i) => f(...operands.map((x) => x[x.length === 1 ? 0 : i])))
  }

/** Returns the shape of a result by component. */
export const widest = (shapes) => Math.max(...shapes)

export const unary = [[1], [2], [3], [4]]
export const binary = [
  [1, 1],
  [2, 2],
  [3, 3],
  [4, 4],
  [3, 1],
  [1, 2],
]
export const ternary = [
  [1, 1, 1],
  [2, 2, 2],
  [3, 3, 3],
  [4, 4, 4],
  [3, 1, 1],
  [1, 2, 1],
  [1, 1, 4],
]

/** The names of a vector's components. */
export const letterSets = ['xyzw', 'rgba', 'stpq', 'uv']

const indexOf = (letter) => Math.max(...letterSets.map((letters) => letters.indexOf(letter)))

/** Returns the numbers that a swizzle selects from a vector. */
export const swizzle = (name, v) => [...name].map((letter) => v[indexOf(letter)])
