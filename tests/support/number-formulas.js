// Evaluates the formulas of .scripts/reference/formulas.mjs, which are JavaScript, in double precision.

const numbers = {
  ...Object.fromEntries(Object.getOwnPropertyNames(Math).map((name) => [name, Math[name]])),
  clamp: (x, low, high) => Math.min(Math.max(x, low), high),
}

/** Names of the operands in the docs. */
const operands = {
  pow: ['x', 'exponent'],
  'atan(y, x)': ['y', 'x'],
  radians: ['degrees'],
  degrees: ['radians'],
  mod: ['x', 'divisor'],
  clamp: ['x', 'low', 'high'],
  mix: ['x', 'y', 'amount'],
  step: ['edge', 'x'],
  smoothstep: ['low', 'high', 'x'],
  ifElse: ['condition', 'yes', 'no'],
}
export const operandsOf = (name, count) => operands[name] ?? ['x', 'y'].slice(0, count)

export function evaluateFormula(text, values, where = {}) {
  const known = { ...numbers, ...values }
  for (const [name, part] of Object.entries(where)) known[name] = evaluateFormula(part, values)
  return new Function(...Object.keys(known), `return ${text}`)(...Object.values(known))
}
