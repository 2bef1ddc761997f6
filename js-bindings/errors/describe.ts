/** Tests for an expression by its properties, since several scripts of a page may each have a copy of the class. */
export const isExpression = (value: unknown): boolean =>
  ((typeof value === 'object' && value !== null) || typeof value === 'function') &&
  'session' in value &&
  'handle' in value

/** The description of vectors such as those of p5's createVector. */
export const vectorOfNumbers = 'a vector of numbers'

/** Describes a value in a message. */
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

/** Tests for a class, which is not callable without `new`: only a class has a `prototype` that cannot be assigned. */
export const isClass = (value: Function): boolean =>
  Object.getOwnPropertyDescriptor(value, 'prototype')?.writable === false

/** Describes an expression by its shape, in a message. */
export function describeShape([columns, rows]: readonly [number, number]): string {
  return columns > 1 ? 'a matrix' : rows > 1 ? `a vec${rows}` : 'a single number'
}

/** Returns the first 60 characters of a string, on one line. */
export function shorten(text: string): string {
  return text.slice(0, 60).replace(/\s+/g, ' ')
}
