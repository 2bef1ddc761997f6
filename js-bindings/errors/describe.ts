/** An expression, known by its shape: there may be several copies of its class, each in a file of its own. */
export const isExpression = (value: unknown): boolean =>
  ((typeof value === 'object' && value !== null) || typeof value === 'function') &&
  'session' in value &&
  'handle' in value

/** Such as p5's createVector makes. */
export const vectorOfNumbers = 'a vector of numbers'

/** How a value that came in is shown in a message. */
export function describe(value: unknown): string {
  if (value === null || value === undefined) return String(value)
  if (typeof value === 'string') return `the text "${shorten(value)}"`
  if (typeof value === 'number') return `the number ${value}`
  if (isExpression(value)) return 'an expression'
  if (typeof value === 'function') return isClass(value) ? 'a class' : 'a function'
  if (Array.isArray(value)) return `an array of ${value.length}`
  if (typeof value === 'object' && 'then' in value) return 'a promise'
  if (typeof value === 'object' && 'x' in value && 'y' in value) return vectorOfNumbers
  if (typeof value === 'object') return Object.keys(value).length ? 'an object' : 'an empty object'
  return `the ${typeof value} ${shorten(String(value))}`
}

/** Whether it can only be called with `new`, and so is no function to a sketch. Of those alone `prototype` is for good. */
export const isClass = (value: Function): boolean =>
  Object.getOwnPropertyDescriptor(value, 'prototype')?.writable === false

/** What an expression of so many columns and rows is. */
export function describeShape([columns, rows]: readonly [number, number]): string {
  return columns > 1 ? 'a matrix' : rows > 1 ? `a vec${rows}` : 'a single number'
}

/** A text from outside, on one line and not too long. */
export function shorten(text: string): string {
  return text.slice(0, 60).replace(/\s+/g, ' ')
}
