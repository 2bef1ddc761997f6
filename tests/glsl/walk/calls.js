// Interprets calls: of functions in the source, built-in functions and constructors.
import { builtIns } from '../built-ins.js'
import { Expressions } from './expressions.js'
import { anyVaries, convert, layoutOf, matrixType, newValue, numbersOf, write } from './values.js'

/** Returns whether a parameter has a name; the `void` of `f(void)` does not. */
const isNamed = ({ identifier }) => identifier

export class Calls extends Expressions {
  value_function_call({ identifier, args }) {
    const operandNodes = args.filter(({ type, token }) => type !== 'literal' && token !== 'void')
    if (identifier.type === 'postfix') return newValue('int', [this.lengthOf(identifier)])
    const word =
      identifier.specifier?.identifier ?? identifier.identifier ?? identifier.specifier.token
    const candidates = this.functions.filter(
      ({ prototype }) => prototype.header.name.identifier === word,
    )
    const operands = operandNodes.map((node) => this.value(node))
    const types = operands.map(({ type }) => type)
    const accepts = ({ prototype }) =>
      `${(prototype.parameters ?? []).filter(isNamed).map((parameter) => this.typeOf(parameter))}` ===
      `${types}`
    const f = candidates.find(accepts)
    if (f) return this.enter(f, operands)
    if (builtIns[word] || word === 'transpose' || word === 'modf')
      return this.builtIn(word, operands)
    return this.construct(this.typeOf({ specifier: identifier }), operands)
  }
  lengthOf({ expression }) {
    const name = expression.identifier?.identifier ?? expression.identifier
    return Number(/\[(\d+)\]$/.exec(this.find(name).type)[1])
  }
  enter({ prototype, body }, operands) {
    const parameters = (prototype.parameters ?? []).filter(isNamed)
    const outer = this.scopes
    this.scopes = [outer[0], new Map()]
    parameters.forEach((parameter, i) =>
      this.declare(
        parameter.identifier.identifier,
        this.typeOf(parameter),
        numbersOf(operands[i]),
        anyVaries(operands[i]),
      ),
    )
    const calleeScopes = this.scopes
    const end = this.sequence(body.statements)
    this.scopes = calleeScopes
    parameters.forEach((parameter, i) => {
      if ((parameter.qualifier ?? []).some(({ token }) => /out/.test(token))) {
        const value = this.find(parameter.identifier.identifier)
        write(operands[i], numbersOf(value), anyVaries(value))
      }
    })
    this.scopes = outer
    return end?.value
  }
  builtIn(name, operands) {
    const lists = operands.map(numbersOf)
    const types = operands.map(({ type }) => type)
    const isVarying = anyVaries(...operands)
    if (name === 'transpose') {
      const { columns, rows } = layoutOf(types[0])
      const transposed = Array.from(
        lists[0],
        (_, i) => lists[0][(i % columns) * rows + Math.floor(i / columns)],
      )
      return newValue(matrixType(rows, columns), transposed, isVarying)
    }
    if (name === 'modf') {
      write(operands[1], lists[0].map(Math.trunc), isVarying)
      return newValue(
        types[0],
        lists[0].map((x) => x - Math.trunc(x)),
        isVarying,
      )
    }
    const { type, run } = builtIns[name]
    const widest =
      types[
        lists.findIndex(({ length }) => length === Math.max(...lists.map((list) => list.length)))
      ]
    return newValue(type ? type(...types) : widest, run(...lists), isVarying)
  }
  construct(named, operands) {
    const all = operands.flatMap(numbersOf)
    const type = named.endsWith('[]') ? named.replace('[]', `[${operands.length}]`) : named
    const layout = layoutOf(type)
    const isVarying = anyVaries(...operands)
    if (!layout) return newValue(type, all, isVarying)
    const { kind, columns, rows } = layout
    const size = columns * rows
    const from = layoutOf(operands[0].type)
    const isAlone = operands.length === 1
    const diagonal = (i, one, other) => (Math.floor(i / rows) === i % rows ? one : other)
    const componentAt = (i) => {
      if (isAlone && columns > 1 && all.length === 1) return diagonal(i, all[0], 0)
      if (isAlone && columns > 1 && from.columns > 1) {
        const [column, row] = [Math.floor(i / rows), i % rows]
        if (column < from.columns && row < from.rows) return all[column * from.rows + row]
        return diagonal(i, 1, 0)
      }
      return all[isAlone && all.length === 1 ? 0 : i]
    }
    return newValue(
      type,
      Array.from({ length: size }, (_, i) => convert[kind](componentAt(i))),
      isVarying,
    )
  }
}
