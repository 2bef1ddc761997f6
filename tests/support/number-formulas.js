// The formulas of .scripts/reference/formulas.mjs in double: they are JavaScript.

const numbers = {
  ...Object.fromEntries(Object.getOwnPropertyNames(Math).map((name) => [name, Math[name]])),
  clamp: (x, low, high) => Math.min(Math.max(x, low), high),
}

/** Names of the operands as the docs have them. */
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

export function evaluated(text, values, where = {}) {
  const known = { ...numbers, ...values }
  for (const [name, part] of Object.entries(where)) known[name] = evaluated(part, values)
  return new Function(...Object.keys(known), `return ${text}`)(...Object.values(known))
}
