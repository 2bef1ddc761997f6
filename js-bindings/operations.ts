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

/** Conversions, which the graph inserts by itself. */
const hidden = new Set(['float', 'bool'])

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

/** A method as it is called: the receiver first, or none for a function of `glsl`. */
export function call(
  compilation: Compilation,
  name: string,
  given: readonly unknown[],
  isMethod: boolean,
): Expression {
  const operands = given.map((operand, i) =>
    toExpression(compilation, name, operand, isMethod ? `argument ${i}` : `argument ${i + 1}`),
  )
  const operation = operations().get(name === 'atan' && operands.length === 2 ? 'atan2' : name)!
  const { arity } = operation
  if (operation.chained && operands.length > (isMethod ? 1 : 0))
    return operands.reduce((sum, operand) => apply(compilation, operation, sum, operand))
  if (operands.length !== arity) {
    const [wanted, came] = isMethod ? [arity - 1, operands.length - 1] : [arity, operands.length]
    throw new WarpError(`${name}: ${argumentCount(wanted)} expected, but ${came} came.`)
  }
  return apply(compilation, operation, ...(operands as [Expression]))
}

function argumentCount(count: number): string {
  return count === 1 ? '1 argument was' : `${count || 'no'} arguments were`
}

function apply(
  compilation: Compilation,
  { code, name }: Operation,
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

function commonSize(name: string, size: number, operand: Expression | undefined): number {
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
    call(first.compilation, name, [first, ...others], true)
}
