// The operators that expressions define anew, by their functions in runtime.ts.
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

/** Returns whether a node is an operator that expressions define anew. Calls are judged by `isCallToTranslate`. */
export const isOperator = ({ type, operator, argument }: Tree): boolean =>
  (type === 'BinaryExpression' && (operator in binary || bits.has(operator))) ||
  (type === 'UnaryExpression' &&
    (operator in unary || operator === '~') &&
    argument.type !== 'Literal') ||
  (type === 'LogicalExpression' && operator in logical) ||
  (type === 'AssignmentExpression' && operator !== '=' && !/^\?\?/.test(operator)) ||
  /^(Conditional|Update)Expression$|^IfStatement$/.test(type)

/** A name for translated text that its source does not have. */
export function unusedName(name: string, source: string): string {
  while (source.includes(name)) name += '_'
  return name
}
