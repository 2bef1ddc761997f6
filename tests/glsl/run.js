// Interprets GLSL statements that the compiler generated, in double precision, for tests only.
import { createRequire } from 'node:module'
import { Statements } from './walk/statements.js'
import { fail, layoutOf, newValue, numbersOf } from './walk/values.js'

const { parser } = createRequire(import.meta.url)('@shaderfrog/glsl-parser')

/** Maps a function → predicate of its operands: whether GLSL leaves the result undefined. The interpreter then returns NaN. */
const isUndefined = {
  pow: (x, y) => x < 0 || (x === 0 && y <= 0),
  smoothstep: (low, high) => low >= high,
}

/** Rejects what a shader compiler rejects, such as wrong types and names that are declared twice. Keeps constants in double precision. */
class Strict extends Statements {
  value_float_constant({ token }) {
    return newValue('float', [parseFloat(token)], true)
  }
  /** Evaluates both values, since nothing in the statements has side effects. */
  value_ternary({ expression, left, right }) {
    const [test, yes, no] = [expression, left, right].map((node) => this.value(node))
    if (test.type !== 'bool') fail(`expected bool before ?, got ${test.type}`)
    if (yes.type !== no.type)
      fail(`expected two values of the same type in ? :, got ${yes.type} and ${no.type}`)
    return this.copy(numbersOf(test)[0] ? yes : no)
  }
  operate(op, left, right, numbers) {
    const [a, b] = [layoutOf(left.type), layoutOf(right.type)]
    if (a.kind !== b.kind) fail(`${op} does not take ${left.type} and ${right.type}`)
    const isProduct = op === '*' && Math.max(a.columns, b.columns) > 1
    const sizes = [a, b].map(({ columns, rows }) => columns * rows)
    if (!isProduct && !sizes.includes(1) && left.type !== right.type)
      fail(`${left.type} and ${right.type} have different sizes`)
    return super.operate(op, left, right, numbers)
  }
  select(value, name) {
    const selected = super.select(value, name)
    const { rows } = layoutOf(value.type)
    const exists = rows > 1 && selected.indices.every((index) => value.indices.includes(index))
    return exists ? selected : fail(`a ${value.type} has no .${name}`)
  }
  builtIn(name, operands) {
    const result = super.builtIn(name, operands)
    const numbers = numbersOf(result).map((number, i) => {
      const components = operands.map(
        ({ storage, indices }) => storage[indices[indices.length === 1 ? 0 : i]],
      )
      return isUndefined[name]?.(...components) ? NaN : number
    })
    return newValue(result.type, numbers, true)
  }
  construct(type, operands) {
    if (!layoutOf(type)) fail(`there is no function ${type}`)
    return super.construct(type, operands)
  }
  declarator_list(list) {
    const scope = this.scopes.at(-1)
    const type = this.typeOf(list.specified_type)
    for (const { identifier, initializer } of list.declarations) {
      const name = identifier.identifier
      if (scope.has(name)) fail(`${name} is declared twice`)
      super.declarator_list({ ...list, declarations: [{ identifier, initializer }] })
      if (!initializer) this.unset.add(scope.get(name))
      else if (scope.get(name).type !== type)
        fail(`${name}: expected ${type}, got ${scope.get(name).type}`)
    }
  }
  value_identifier({ identifier }) {
    const value = this.find(identifier)
    return this.unset.has(value) ? fail(`${identifier} is not set`) : value
  }
  value_assignment({ left, operator, right }) {
    const [place, value] = [this.find(left.identifier), this.value(right)]
    if (value.type !== place.type)
      fail(`${left.identifier}: expected ${place.type}, got ${value.type}`)
    this.unset.delete(place)
    return super.value_assignment({ left, operator, right })
  }

  /** Runs the statements, which may read `inputs`; returns the values of all variables that are set, by name. */
  run(statements, inputs) {
    this.unset = new Set()
    this.scopes = [new Map()]
    for (const [name, value] of Object.entries(inputs))
      this.declare(name, typeOf(value), [value].flat(), true)
    this.sequence(statements)
    const valueOf = (value) => {
      const numbers = numbersOf(value)
      return numbers.length > 1 ? numbers : numbers[0]
    }
    const set = [...this.scopes[0]].filter(([, value]) => !this.unset.has(value))
    return Object.fromEntries(set.map(([name, value]) => [name, valueOf(value)]))
  }
}

const typeOf = (value) =>
  Array.isArray(value) ? `vec${value.length}` : typeof value === 'number' ? 'float' : 'bool'

/** Caches the parsed statements of each code, since tests run the same code at many points. */
const parsed = new Map()

function statementsOf(code) {
  if (!parsed.has(code)) {
    const [{ body }] = parser.parse(`void run() {\n${code}\n}`, { quiet: true }).program
    parsed.set(code, body.statements)
  }
  return parsed.get(code)
}

/**
 * Runs statements that may read the variables of `inputs`; returns the values of all variables that are set, by name. Numbers are floats,
 * arrays of two to four numbers are vectors, true and false are bools.
 */
export const runGlsl = (code, inputs = {}) => new Strict([]).run(statementsOf(code), inputs)
