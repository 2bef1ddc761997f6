// Values, which are numbers with a type, and the results of operators on them.

export const fail = (message) => {
  throw new SyntaxError(`the interpreter: ${message}`)
}

const layouts = new Map()

/** Returns { kind, columns, rows } of a type; `undefined` for structures and arrays. Memoized, since long loops need it often. */
export function layoutOf(type) {
  if (!layouts.has(type)) layouts.set(type, readLayout(type))
  return layouts.get(type)
}

function readLayout(type) {
  const [, letter, size] = /^([iub]?)vec(\d)$/.exec(type) ?? []
  if (size) {
    const kind = { '': 'float', i: 'int', u: 'uint', b: 'bool' }[letter]
    return { kind, columns: 1, rows: Number(size) }
  }
  const [, columns, rows = columns] = /^mat(\d)(?:x(\d))?$/.exec(type) ?? []
  if (columns) return { kind: 'float', columns: Number(columns), rows: Number(rows) }
  return /^(?:float|u?int|bool)$/.test(type) ? { kind: type, columns: 1, rows: 1 } : undefined
}
export const matrixType = (columns, rows) =>
  columns === rows ? `mat${rows}` : `mat${columns}x${rows}`

export const wrap = { int: (x) => x | 0, uint: (x) => x >>> 0, float: (x) => x }
export const convert = {
  float: Number,
  int: (x) => Math.trunc(Number(x)) | 0,
  uint: (x) => Math.trunc(Number(x)) >>> 0,
  bool: Boolean,
}
export const operations = {
  '+': (x, y) => x + y,
  '-': (x, y) => x - y,
  '*': (x, y, kind) => (kind === 'float' ? x * y : Math.imul(x, y)),
  '/': (x, y, kind) => (kind === 'float' ? x / y : Math.trunc(x / y)),
  '%': (x, y) => x % y,
  '&': (x, y) => x & y,
  '|': (x, y) => x | y,
  '^': (x, y) => x ^ y,
  '<<': (x, y) => x << y,
  '>>': (x, y, kind) => (kind === 'uint' ? x >>> y : x >> y),
}
export const comparisons = {
  '<': (x, y) => x < y,
  '>': (x, y) => x > y,
  '<=': (x, y) => x <= y,
  '>=': (x, y) => x >= y,
}

/** Makes a value that refers to numbers, its own or those of a variable: those of the array `of` at the indices `at`. */
export const part = (type, of, at) => ({ type, of, at })
export const numbersOf = ({ of, at }) =>
  at.length === 1 ? [of[at[0]]] : at.map((place) => of[place])

/** Returns whether one of the values depends on the arguments. All others are constants, which a shader compiler rounds to float32. */
export function vary(...values) {
  for (const { of } of values) if (of[varies]) return true
  return false
}
const varies = Symbol('varies')

/** Maps the size of a value → the indices of all its numbers. Shared by all values, since nothing writes to them. */
const allIndices = Array.from({ length: 17 }, (_, size) =>
  Array.from({ length: size }, (_, i) => i),
)
const indicesOf = (numbers) => allIndices[numbers.length] ?? [...numbers.keys()]

export function fresh(type, numbers, isVarying) {
  const of = isVarying || layoutOf(type)?.kind !== 'float' ? numbers : numbers.map(Math.fround)
  of[varies] = !!isVarying
  return part(type, of, indicesOf(of))
}
export function write({ of, at }, numbers, isVarying) {
  at.forEach((place, i) => (of[place] = numbers[i]))
  if (isVarying) of[varies] = true
  else if (at.length === of.length) of[varies] = false
}

/** Multiplies matrices and vectors. A vector to the left of a matrix is a row, one to its right a column. */
export function multiply(a, x, b, y, isVarying) {
  const [rows, inner] = a.columns > 1 ? [a.rows, a.columns] : [1, a.rows]
  const columns = b.columns > 1 ? b.columns : 1
  const at = (row, k) => (a.columns > 1 ? x[k * rows + row] : x[k])
  const numbers = Array.from({ length: columns * rows }, (_, i) => {
    const [column, row] = [Math.floor(i / rows), i % rows]
    let sum = 0
    for (let k = 0; k < inner; k++) sum += at(row, k) * y[column * inner + k]
    return sum
  })
  const size = Math.max(columns, rows)
  return fresh(
    columns > 1 && rows > 1 ? matrixType(columns, rows) : `vec${size}`,
    numbers,
    isVarying,
  )
}
