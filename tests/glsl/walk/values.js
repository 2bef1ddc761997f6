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

/** Makes a value whose numbers are those of `storage` at `indices`. `storage` can be that of a variable. */
export const valueIn = (type, storage, indices) => ({ type, storage, indices })
export const numbersOf = ({ storage, indices }) =>
  indices.length === 1 ? [storage[indices[0]]] : indices.map((index) => storage[index])

/** Returns whether one of the values depends on the arguments. All others are constants, which a shader compiler rounds to float32. */
export function anyVaries(...values) {
  for (const { storage } of values) if (storage[varies]) return true
  return false
}
const varies = Symbol('varies')

/** Maps the size of a value → the indices of all its numbers. Shared by all values, since nothing writes to them. */
const allIndices = Array.from({ length: 17 }, (_, size) =>
  Array.from({ length: size }, (_, i) => i),
)
const indicesOf = (numbers) => allIndices[numbers.length] ?? [...numbers.keys()]

export function newValue(type, numbers, isVarying) {
  const storage = isVarying || layoutOf(type)?.kind !== 'float' ? numbers : numbers.map(Math.fround)
  storage[varies] = !!isVarying
  return valueIn(type, storage, indicesOf(storage))
}
export function write({ storage, indices }, numbers, isVarying) {
  indices.forEach((index, i) => (storage[index] = numbers[i]))
  if (isVarying) storage[varies] = true
  else if (indices.length === storage.length) storage[varies] = false
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
  return newValue(
    columns > 1 && rows > 1 ? matrixType(columns, rows) : `vec${size}`,
    numbers,
    isVarying,
  )
}
