// How far float32 on a GPU may be from the reference: { value, derivative, because }. An error is
// measured in proportion to the expected number where that is above 1, and to the row's
// `sensitivity` where it has one, { value, derivative, because }: by how much the mathematics
// itself enlarges an error of an operand or of a rounding, one number for each component of the
// result, worked out by hand. The bounds are two to four times what was measured on SwiftShader.

/** Sums, products and quotients, roots, and whatever only chooses. */
export const rounding = {
  value: 2e-6,
  derivative: 2e-6,
  because: 'a few roundings of float32, 6e-8 each',
}

export const sine = {
  value: 5e-4,
  derivative: 1e-3,
  because: "SwiftShader's own sine and cosine are 2e-4 off, and factors enlarge that",
}

export const arcCosine = {
  value: 1e-4,
  derivative: 2e-6,
  because: "SwiftShader's own arc cosine is 5e-5 off",
}

export const exponential = {
  value: 2e-6,
  derivative: 2e-6,
  because: 'powers of 2 and logarithms to a few units of the last place',
}

export const power = {
  value: 1e-5,
  derivative: 1e-5,
  because: 'the exponent multiplies the error of the logarithm',
}
