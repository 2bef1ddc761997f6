// Interprets expressions: operators, and components of values.
import { ofKind } from '../built-ins.js'
import { Names } from './names.js'
import {
  anyVaries,
  comparisons,
  fail,
  layoutOf,
  multiply,
  newValue,
  numbersOf,
  operations,
  valueIn,
  wrap,
  write,
} from './values.js'

/** Caches the name of the method of each type of node, since long loops look up many. */
const methods = {}

export class Expressions extends Names {
  copy(value) {
    return newValue(value.type, numbersOf(value), anyVaries(value))
  }
  test(node) {
    return numbersOf(this.value(node))[0]
  }
  value(node) {
    const method = (methods[node.type] ??= `value_${node.type}`)
    return this[method]
      ? this[method](node)
      : fail(`an expression of type ${node.type} is not supported`)
  }
  value_group({ expression }) {
    return this.value(expression)
  }
  value_identifier({ identifier }) {
    return this.find(identifier)
  }
  /** Memoizes the value in the node, since nothing writes to a literal. */
  value_float_constant(node) {
    return (node.value ??= newValue('float', [parseFloat(node.token)]))
  }
  value_int_constant({ token }) {
    const isUnsigned = /u$/i.test(token)
    const digits = token.replace(/u$/i, '')
    const number = Number(/^0\d/.test(digits) ? `0o${digits}` : digits)
    return isUnsigned ? newValue('uint', [number]) : newValue('int', [number | 0])
  }
  value_uint_constant(node) {
    return this.value_int_constant(node)
  }
  value_bool_constant({ token }) {
    return newValue('bool', [token === 'true'])
  }
  value_ternary({ expression, left, right }) {
    return this.copy(this.value(this.test(expression) ? left : right))
  }
  value_unary({ operator, expression }) {
    const op = operator.literal
    if (op === '++' || op === '--') return this.step(this.value(expression), op)
    const operand = this.value(expression)
    const { kind } = layoutOf(operand.type)
    const f = {
      '-': (x) => wrap[kind](-x),
      '+': (x) => x,
      '!': (x) => !x,
      '~': (x) => wrap[kind](~x),
    }
    return newValue(operand.type, numbersOf(operand).map(f[op]), anyVaries(operand))
  }
  step(place, op) {
    const { kind } = layoutOf(place.type)
    const by = op === '++' ? 1 : -1
    write(
      place,
      numbersOf(place).map((x) => wrap[kind](x + by)),
      anyVaries(place),
    )
    return place
  }
  value_postfix({ expression, postfix }) {
    let value = this.value(expression)
    for (let next = postfix; next; next = next.type === 'postfix' ? next.postfix : undefined) {
      const access = next.type === 'postfix' ? next.expression : next
      if (access.type === 'field_selection') value = this.select(value, access.selection.identifier)
      else if (access.type === 'quantifier')
        value = this.element(value, this.value(access.expression))
      else {
        const before = this.copy(value)
        this.step(value, access.literal)
        return before
      }
    }
    return value
  }
  select({ type, storage, indices }, name) {
    const fields = this.structures[type]
    if (!fields) {
      const places = [...name].map((letter) =>
        Math.max(...['xyzw', 'rgba', 'stpq'].map((letters) => letters.indexOf(letter))),
      )
      const { kind } = layoutOf(type)
      const selectedType = places.length === 1 ? kind : ofKind(kind, `vec${places.length}`)
      return valueIn(
        selectedType,
        storage,
        places.map((place) => indices[place]),
      )
    }
    let offset = 0
    for (const field of fields) {
      const size = this.sizeOf(field.type)
      if (field.name === name)
        return valueIn(field.type, storage, indices.slice(offset, offset + size))
      offset += size
    }
    return fail(`${type} has no ${name}`)
  }
  element({ type, storage, indices }, index) {
    const [, inner] = /^(.*)\[\d+\]$/.exec(type) ?? []
    const layout = layoutOf(type)
    const element = inner ?? (layout.columns > 1 ? `vec${layout.rows}` : layout.kind)
    const size = this.sizeOf(element)
    const [i] = numbersOf(index)
    return valueIn(element, storage, indices.slice(i * size, (i + 1) * size))
  }
  value_assignment({ left, operator, right }) {
    const place = this.value(left)
    const op = operator.literal.slice(0, -1)
    const operand = this.value(right)
    const value = op ? this.operate(op, place, operand) : operand
    write(place, numbersOf(value), anyVaries(value))
    return place
  }
  value_binary({ operator, left, right }) {
    const op = operator.literal
    if (op === ',') return (this.value(left), this.value(right))
    if (op === '&&') return newValue('bool', [this.test(left) && this.test(right)])
    if (op === '||') return newValue('bool', [this.test(left) || this.test(right)])
    // The right operand may change the variable on the left.
    const first = this.value(left)
    const numbers = numbersOf(first)
    return this.operate(op, first, this.value(right), numbers)
  }
  operate(op, left, right, x = numbersOf(left)) {
    const y = numbersOf(right)
    if (op === '^^') return newValue('bool', [x[0] !== y[0]])
    if (op === '==' || op === '!=')
      return newValue('bool', [x.every((number, i) => number === y[i]) === (op === '==')])
    if (comparisons[op]) return newValue('bool', [comparisons[op](x[0], y[0])])
    const [a, b] = [layoutOf(left.type), layoutOf(right.type)]
    if (op === '*' && Math.max(a.columns, b.columns) > 1 && x.length > 1 && y.length > 1)
      return multiply(a, x, b, y, anyVaries(left, right))
    const f = operations[op]
    const isVarying = anyVaries(left, right)
    if (x.length === 1 && y.length === 1)
      return newValue(left.type, [wrap[a.kind](f(x[0], y[0], a.kind))], isVarying)
    const type = x.length >= y.length ? left.type : right.type
    const at = (list, i) => list[list.length === 1 ? 0 : i]
    const size = Math.max(x.length, y.length)
    return newValue(
      type,
      Array.from({ length: size }, (_, i) => wrap[a.kind](f(at(x, i), at(y, i), a.kind))),
      isVarying,
    )
  }
}
