// Evaluates the formulas of .scripts/reference/formulas.mjs, which are JavaScript, in double precision.

const numbers = {
  ...Object.fromEntries(Object.getOwnPropertyNames(Math).map((name) => [name, Math[name]])),
  clamp: (x, low, high) => Math.min(Math.max(x, low), high),
}

/** Maps an operation → the names of its operands in the docs, unless these are x and y. */
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

/** Evaluates a formula; `where` defines names in it. */
export function evaluateFormula(text, values, where = {}) {
  const scope = { ...numbers, ...values }
  for (const [name, definition] of Object.entries(where))
    scope[name] = evaluateFormula(definition, values)
  return new Function(...Object.keys(scope), `return ${text}`)(...Object.values(scope))
}
