// Tolerances of float32 on a GPU against the reference: { value, derivative, because }. Before it is compared, an error is divided by the
// expected number if that is above 1, and by the `sensitivity` of the row if the row has one. The sensitivity, { value, derivative,
// because }, is the factor by which the mathematics itself amplifies an error of an operand or of rounding: one number for each component
// of the result, from a formula derived by hand. The bounds are two to four times the errors measured on SwiftShader.

/** Sums, products and quotients, roots, and operations that only select. */
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
