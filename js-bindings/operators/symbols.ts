// Maps the operators that are overloaded for expressions to their functions in runtime.ts.
import type { Tree } from './tree.js'

export const binary: Readonly<Record<string, string>> = {
  '+': 'add',
  '-': 'sub',
  '*': 'mult',
  '/': 'div',
  '%': 'mod',
  '**': 'pow',
  '<': 'lt',
  '<=': 'le',
  '>': 'gt',
  '>=': 'ge',
  '==': 'looseEq',
  '===': 'eq',
  '!=': 'looseNe',
  '!==': 'ne',
}
export const bits: ReadonlySet<string> = new Set(['|', '&', '^', '<<', '>>', '>>>'])
export const unary: Readonly<Record<string, string>> = { '-': 'neg', '+': 'plus', '!': 'not' }
export const logical: Readonly<Record<string, string>> = { '&&': 'and', '||': 'or' }

/** Returns whether a node is an operator that is overloaded for expressions. `isCallToTranslate` checks calls. */
export const isOperator = ({ type, operator, argument }: Tree): boolean =>
  (type === 'BinaryExpression' && (operator in binary || bits.has(operator))) ||
  (type === 'UnaryExpression' &&
    (operator in unary || operator === '~') &&
    argument.type !== 'Literal') ||
  (type === 'LogicalExpression' && operator in logical) ||
  (type === 'AssignmentExpression' && operator !== '=' && !/^\?\?/.test(operator)) ||
  /^(Conditional|Update)Expression$|^IfStatement$/.test(type)

/** Appends underscores to a name until the source does not contain it. */
export function unusedName(name: string, source: string): string {
  while (source.includes(name)) name += '_'
  return name
}
