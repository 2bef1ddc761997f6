// Interprets statements; each returns how it ends, or `undefined` if the next one follows.
import { Calls } from './calls.js'
import { anyVaries, fail, numbersOf } from './values.js'

class Return {
  constructor(value) {
    this.value = value
  }
}
const [Break, Continue] = [Symbol('break'), Symbol('continue')]

export class Statements extends Calls {
  statement(node) {
    return (this[node.type] ?? fail(`a statement of type ${node.type} is not supported`)).call(
      this,
      node,
    )
  }
  sequence(nodes) {
    for (const node of nodes) {
      const end = this.statement(node)
      if (end) return end
    }
    return undefined
  }
  compound_statement({ statements }) {
    return this.inNewScope(() => this.sequence(statements))
  }
  declaration_statement({ declaration }) {
    return this.statement(declaration)
  }
  precision() {}
  preprocessor() {}
  declarator_list({ specified_type, declarations }) {
    const base = this.typeOf(specified_type)
    for (const { identifier, quantifier, initializer } of declarations) {
      const value = initializer && this.value(initializer)
      const type = value?.type ?? this.withLengths(base, quantifier)
      this.declare(
        identifier.identifier,
        type,
        value && numbersOf(value),
        value && anyVaries(value),
      )
    }
  }
  expression_statement({ expression }) {
    if (expression) this.value(expression)
  }
  if_statement({ condition, body, else: otherwise }) {
    const branch = this.test(condition) ? body : [otherwise].flat().at(-1)
    return branch ? this.inNewScope(() => this.statement(branch)) : undefined
  }
  for_statement({ init, condition, operation, body }) {
    return this.inNewScope(() => {
      if (init) init.type === 'declarator_list' ? this.statement(init) : this.value(init)
      return this.loop(condition, body, operation)
    })
  }
  while_statement({ condition, body }) {
    return this.loop(condition, body)
  }
  do_statement({ expression, body }) {
    return this.loop(expression, body, undefined, true)
  }
  loop(condition, body, step, isLate = false) {
    for (let isFirst = true; (isFirst && isLate) || this.test(condition); isFirst = false) {
      const end = this.inNewScope(() => this.statement(body))
      if (end === Break) return undefined
      if (end instanceof Return) return end
      if (step) this.value(step)
    }
    return undefined
  }
  switch_statement({ expression, cases }) {
    const [value] = numbersOf(this.value(expression))
    const isMatching = ({ type, test }) =>
      type === 'switch_case' && numbersOf(this.value(test))[0] === value
    const matching = cases.findIndex(isMatching)
    const first = matching >= 0 ? matching : cases.findIndex(({ type }) => type === 'default_case')
    if (first < 0) return undefined
    const end = this.inNewScope(() =>
      this.sequence(cases.slice(first).flatMap(({ statements }) => statements)),
    )
    return end === Break ? undefined : end
  }
  break_statement() {
    return Break
  }
  continue_statement() {
    return Continue
  }
  return_statement({ expression }) {
    return new Return(expression && this.copy(this.value(expression)))
  }
}
