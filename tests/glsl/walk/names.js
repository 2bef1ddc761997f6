// Looks up types and variables: the number of components of a type, and the value of a name.
import { fail, layoutOf, newValue, numbersOf } from './values.js'

export class Names {
  constructor(program) {
    this.program = program
    this.functions = []
    this.structures = {}
  }

  // types

  sizeOf(type) {
    const layout = layoutOf(type)
    if (layout) return layout.columns * layout.rows
    const [, element, count] = /^(.*)\[(\d+)\]$/.exec(type) ?? []
    if (element) return this.sizeOf(element) * Number(count)
    return this.structures[type].reduce((sum, field) => sum + this.sizeOf(field.type), 0)
  }

  /** Returns the type of a declaration with a specifier, and possibly an array length after its name. */
  typeOf({ specifier, quantifier }) {
    const word = specifier.specifier ?? specifier
    const named = word.type === 'struct' ? this.structure(word) : (word.token ?? word.identifier)
    return [specifier.quantifier, quantifier].reduce(
      (type, lengthNodes) => this.withLengths(type, lengthNodes),
      named,
    )
  }
  withLengths(type, lengthNodes) {
    const lengthText = ({ expression }) => (expression ? numbersOf(this.value(expression))[0] : '')
    return (lengthNodes ?? []).reduce((name, length) => `${name}[${lengthText(length)}]`, type)
  }

  structure({ typeName, declarations }) {
    const fields = declarations.flatMap(({ declaration }) =>
      declaration.declarations.map(({ identifier, quantifier }) => ({
        name: identifier.identifier,
        type: this.withLengths(this.typeOf(declaration.specified_type), quantifier),
      })),
    )
    this.structures[typeName.identifier] = fields
    return typeName.identifier
  }

  // names

  declare(name, type, numbers, isVarying = false) {
    const start = numbers ?? Array(this.sizeOf(type)).fill(0)
    this.scopes.at(-1).set(name, newValue(type, [...start], isVarying))
  }

  find(name) {
    for (let i = this.scopes.length - 1; i >= 0; i--)
      if (this.scopes[i].has(name)) return this.scopes[i].get(name)
    return fail(`${name} is not declared`)
  }

  inNewScope(work) {
    this.scopes.push(new Map())
    const result = work()
    this.scopes.pop()
    return result
  }
}
