// The rows of the operation table as methods. A scalar beside a vector counts for each component.
import type { Compilation } from './compilation.js'
import { getCore } from './core.js'
import { WarpError } from './errors.js'
import { Expression, type Operand, sizeName, toExpression } from './expression.js'

/** A row of the table, by its number. */
interface Operation {
  code: number
  name: string
  arity: number
  chained: boolean
}

/** Operations that take any number of operands, from left to right. */
const chained = new Set(['add', 'sub', 'mult', 'div', 'min', 'max', 'and', 'or'])

/** Other names of operations, as glsl-autodiff has them. */
const aliases = {
  sum: 'add',
  prod: 'mult',
  vecSum: 'add',
  vecProd: 'mult',
  vecMix: 'mix',
  vecClamp: 'clamp',
  vecMin: 'min',
  vecMax: 'max',
  vecIfElse: 'ifElse',
}

/** Conversions, which the graph inserts by itself, and the row behind `atan` of two operands. */
const hidden = new Set(['float', 'bool', 'atan2'])

let table: Map<string, Operation> | undefined

function operations(): Map<string, Operation> {
  if (table) return table
  table = new Map()
  for (const [code, { name, arity }] of getCore().operations().entries())
    table.set(name, { code, name, arity, chained: chained.has(name) })
  for (const [alias, name] of Object.entries(aliases))
    table.set(alias, { ...table.get(name)!, name: alias })
  return table
}

/** The names that are methods. */
export function operationNames(): string[] {
  return [...operations().keys()].filter((name) => !hidden.has(name))
}

/** An operation by name: of the receiver if it is called as a method, or a function of `glsl`. */
export function call(
  compilation: Compilation,
  name: string,
  given: readonly unknown[],
  receiver?: Expression,
): Expression {
  const operands = receiver ? [receiver] : []
  for (let i = 0; i < given.length; i++)
    operands.push(toExpression(compilation, name, given[i], i + 1))
  const operation = operations().get(name === 'atan' && operands.length === 2 ? 'atan2' : name)!
  if (operation.chained && given.length > 0)
    return operands.reduce((sum, operand) => apply(compilation, operation, name, sum, operand))
  if (operands.length !== operation.arity) {
    const wanted = argumentCount(operation.arity - (receiver ? 1 : 0))
    throw new WarpError(`${name}: ${wanted} expected, but ${given.length} came.`)
  }
  return apply(compilation, operation, name, ...(operands as [Expression]))
}

function argumentCount(count: number): string {
  return count === 1 ? '1 argument was' : `${count || 'no'} arguments were`
}

function apply(
  compilation: Compilation,
  { code }: Operation,
  name: string,
  a: Expression,
  b?: Expression,
  c?: Expression,
): Expression {
  const size = commonSize(name, commonSize(name, a.ids.length, b), c)
  const ids = new Array<number>(size)
  for (let i = 0; i < size; i++)
    ids[i] = compilation.node(code, component(a, i), component(b, i), component(c, i), name)
  return new Expression(compilation, ids)
}

function component(operand: Expression | undefined, i: number): number {
  return operand ? operand.ids[operand.ids.length === 1 ? 0 : i]! : 0
}

/** The size of the result for one more operand. */
export function commonSize(name: string, size: number, operand: Expression | undefined): number {
  const other = operand?.ids.length ?? 1
  if (size !== 1 && other !== 1 && size !== other)
    throw new WarpError(
      `${name}: ${sizeName(size)} and ${sizeName(other)} do not fit together; use vectors of one size, or numbers.`,
    )
  return Math.max(size, other)
}

/** An operation as a function, for the formulas of other files. */
export function operation(name: string) {
  return (first: Expression, ...others: Operand[]): Expression =>
    call(first.compilation, name, others, first)
}
