// Runs GLSL statements of the compiler in double precision, for tests only.
import { createRequire } from 'node:module'
import { Statements } from './walk/statements.js'
import { fail, fresh, layoutOf, numbersOf } from './walk/values.js'

const { parser } = createRequire(import.meta.url)('@shaderfrog/glsl-parser')

/** Maps functions to the operands for which GLSL defines no result: it is NaN here. */
const isUndefined = {
  pow: (x, y) => x < 0 || (x === 0 && y <= 0),
  smoothstep: (low, high) => low >= high,
}

/** Rejects what a shader's compiler rejects, such as wrong types and names that are declared twice, and keeps constants in double. */
class Strict extends Statements {
  value_float_constant({ token }) {
    return fresh('float', [parseFloat(token)], true)
  }
  /** Evaluates both values, since nothing in the statements has side effects. */
  value_ternary({ expression, left, right }) {
    const [test, yes, no] = [expression, left, right].map((node) => this.value(node))
    if (test.type !== 'bool') fail(`${test.type} where bool belongs`)
    if (yes.type !== no.type) fail(`a choice of ${yes.type} or ${no.type}`)
    return this.copy(numbersOf(test)[0] ? yes : no)
  }
  operate(op, left, right, numbers) {
    const [a, b] = [layoutOf(left.type), layoutOf(right.type)]
    if (a.kind !== b.kind) fail(`${left.type} ${op} ${right.type}`)
    const isProduct = op === '*' && Math.max(a.columns, b.columns) > 1
    const sizes = [a, b].map(({ columns, rows }) => columns * rows)
    if (!isProduct && !sizes.includes(1) && left.type !== right.type)
      fail(`${left.type} and ${right.type} have different sizes`)
    return super.operate(op, left, right, numbers)
  }
  select(value, name) {
    const selected = super.select(value, name)
    const { rows } = layoutOf(value.type)
    const isThere = rows > 1 && selected.at.every((place) => value.at.includes(place))
    return isThere ? selected : fail(`.${name} of ${value.type}`)
  }
  builtIn(name, operands) {
    const result = super.builtIn(name, operands)
    const numbers = numbersOf(result).map((number, i) => {
      const given = operands.map(({ of, at }) => of[at[at.length === 1 ? 0 : i]])
      return isUndefined[name]?.(...given) ? NaN : number
    })
    return fresh(result.type, numbers, true)
  }
  construct(type, operands) {
    if (!layoutOf(type)) fail(`${type} is no function`)
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
        fail(`${name} is ${type}, its value ${scope.get(name).type}`)
    }
  }
  value_identifier({ identifier }) {
    const value = this.find(identifier)
    return this.unset.has(value) ? fail(`${identifier} is not set`) : value
  }
  value_assignment({ left, operator, right }) {
    const [place, value] = [this.find(left.identifier), this.value(right)]
    if (value.type !== place.type)
      fail(`${left.identifier} is ${place.type}, its value ${value.type}`)
    this.unset.delete(place)
    return super.value_assignment({ left, operator, right })
  }

  /** Runs the statements, which may read `inputs` → all variables by name. */
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

/** The statements of code that was run before, since tests run the same code at many points. */
const parsed = new Map()

function statementsOf(code) {
  if (!parsed.has(code)) {
    const [{ body }] = parser.parse(`void run() {\n${code}\n}`, { quiet: true }).program
    parsed.set(code, body.statements)
  }
  return parsed.get(code)
}

/**
 * Runs statements with the values of variables by name; returns all variables by name. Numbers are floats, arrays of two to four numbers
 * are vectors, true and false are bools.
 */
export const runGlsl = (code, inputs = {}) => new Strict([]).run(statementsOf(code), inputs)
