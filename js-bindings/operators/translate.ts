// From the text of a function, whose operators work on numbers, to one whose operators ask what they work on. Lines stay where
// they are, so that errors name the sketch's own.
import { functionNames } from './runtime.js'
import { assignedIn, walk } from './scopes.js'
import type { Tree } from './tree.js'

const binary: Record<string, string> = {
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
  '==': 'eq',
  '===': 'eq',
  '!=': 'ne',
  '!==': 'ne',
}
const unary: Record<string, string> = { '-': 'neg', '+': 'plus', '!': 'not' }
const logical: Record<string, string> = { '&&': 'and', '||': 'or' }

/** What the operators are called in translated text. */
export const operatorsName = 'warpjetOperators'

/** The text of `tree`, part of `source`, translated. `isOwn` says whether a name is declared in the function. */
export function translate(source: string, tree: Tree, isOwn: (name: string) => boolean): string {
  const op = (name: string, ...operands: string[]) =>
    `${operatorsName}.${name}(${operands.join(', ')})`

  function text(node: Tree): string {
    const rewritten = rewrite(node)
    if (rewritten !== undefined) return rewritten
    let result = ''
    let at = node.start
    for (const child of childrenOf(node)) {
      result += source.slice(at, child.start) + text(child)
      at = child.end
    }
    return result + source.slice(at, node.end)
  }

  /** As many lines as the node has. */
  const onItsLines = (node: Tree, translated: string) => {
    const lines = (part: string) => part.split('\n').length
    return (
      translated +
      '\n'.repeat(Math.max(0, lines(source.slice(node.start, node.end)) - lines(translated)))
    )
  }
  const between = (a: Tree, b: Tree) =>
    '\n'.repeat(source.slice(a.end, b.start).split('\n').length - 1)

  function rewrite(node: Tree): string | undefined {
    switch (node.type) {
      case 'BinaryExpression':
        return binary[node.operator]
          ? op(
              binary[node.operator]!,
              text(node.left),
              between(node.left, node.right) + text(node.right),
            )
          : undefined
      case 'UnaryExpression':
        return unary[node.operator] && node.argument.type !== 'Literal'
          ? op(unary[node.operator]!, text(node.argument))
          : undefined
      case 'LogicalExpression':
        return logical[node.operator]
          ? op(
              logical[node.operator]!,
              text(node.left),
              `${between(node.left, node.right)}() => ${body(node.right)}`,
            )
          : undefined
      case 'ConditionalExpression':
        return op(
          'choose',
          text(node.test),
          `${between(node.test, node.consequent)}() => ${body(node.consequent)}`,
          `${between(node.consequent, node.alternate)}() => ${body(node.alternate)}`,
        )
      case 'AssignmentExpression': {
        const assigned = assignment(node)
        return assigned && `(${assigned})`
      }
      case 'ExpressionStatement':
        return statement(node)
      case 'CallExpression':
        return called(node)
      case 'BlockStatement':
        return `{${statements(node.body, node.start + 1, node.end - 1)}}`
      case 'IfStatement':
        return onItsLines(node, branch(node))
      case 'WhileStatement':
      case 'DoWhileStatement':
      case 'ForStatement':
        return loop(node)
      default:
        return undefined
    }
  }

  function assignment({ operator, left, right }: Tree): string | undefined {
    const name = binary[operator.slice(0, -1)]
    if (operator === '=' || !name) return undefined
    const target = text(left)
    return `${target} = ${op(name, target, between(left, right) + text(right))}`
  }

  /** Its value is not read. Without parentheses, which would call what stands on the line before. */
  function statement({ expression }: Tree): string | undefined {
    const { type, argument, operator } = expression
    if (type === 'UpdateExpression' && argument.type === 'Identifier')
      return `${argument.name} = ${op(operator === '++' ? 'add' : 'sub', argument.name, '1')};`
    const assigned = type === 'AssignmentExpression' && assignment(expression)
    return assigned ? `${assigned};` : undefined
  }

  const body = (node: Tree) => (node.type === 'ObjectExpression' ? `(${text(node)})` : text(node))

  function called({ callee, arguments: given }: Tree): string | undefined {
    const isMath =
      callee.type === 'MemberExpression' && !callee.computed && callee.object.name === 'Math'
    const name: unknown = isMath ? callee.property.name : callee.name
    const isKnown =
      typeof name === 'string' &&
      functionNames.has(name) &&
      (isMath ? !isOwn('Math') : callee.type === 'Identifier' && !isOwn(name))
    if (!isKnown || given.some(({ type }: Tree) => type === 'SpreadElement')) return undefined
    const plain = isMath ? `Math.${name}` : `(...x) => ${name}(...x)`
    return op(
      'call',
      `'${name}'`,
      plain,
      ...given.map((each: Tree, i: number) => (i ? between(given[i - 1], each) : '') + text(each)),
    )
  }

  function loop(node: Tree): string | undefined {
    if (!node.test) return undefined
    const before = source.slice(node.start, node.test.start)
    const start =
      node.type === 'ForStatement' && node.init
        ? pieces(node.start, node.test.start, [node.init])
        : before
    if (node.type === 'DoWhileStatement')
      return `${pieces(node.start, node.test.start, [node.body])}${op('decided', text(node.test), "'A loop'")}${source.slice(node.test.end, node.end)}`
    const rest = node.update ? [node.update, node.body] : [node.body]
    return `${start}${op('decided', text(node.test), "'A loop'")}${pieces(node.test.end, node.end, rest)}`
  }

  function pieces(start: number, end: number, nodes: Tree[]) {
    let result = ''
    let at = start
    for (const node of nodes) {
      result += source.slice(at, node.start) + text(node)
      at = node.end
    }
    return result + source.slice(at, end)
  }

  /** Statements in order; where an `if` returns, the rest of them is what happens otherwise. */
  function statements(list: Tree[], start: number, end: number): string {
    let result = ''
    let at = start
    for (const [i, node] of list.entries()) {
      result += source.slice(at, node.start)
      if (node.type === 'IfStatement' && leaves(node, 'ReturnStatement')) {
        const rest = statements(list.slice(i + 1), node.end, end)
        return result + returning(node, rest)
      }
      result += text(node)
      at = node.end
    }
    return result + source.slice(at, end)
  }

  /** `if (c) return a; rest`: by vertex, where both a and the rest are values. */
  function returning({ test, consequent, alternate }: Tree, rest: string): string {
    const block = (node: Tree | null) =>
      !node
        ? ''
        : node.type === 'BlockStatement'
          ? statements(node.body, node.start + 1, node.end - 1)
          : statements([node], node.start, node.end)
    const ends = (node: Tree | null) => !!node && endsInReturn(node)
    const after = ends(consequent) && ends(alternate) ? '' : 'return warpjetRest();'
    return (
      (after && `const warpjetRest = () => {${rest}\n};`).replaceAll(/\n(?=\};$)/g, ' ') +
      `return ${op('choose', text(test), `() => {${block(consequent)}; ${ends(consequent) ? '' : after}}`, `() => {${block(alternate)}; ${ends(alternate) ? '' : after}}`)}`
    )
  }

  function branch(node: Tree): string {
    const { test, consequent, alternate } = node
    const isLeft = ['BreakStatement', 'ContinueStatement', 'ReturnStatement'].some((type) =>
      leaves(node, type),
    )
    if (isLeft)
      return `if (${op('decided', text(test), "'Leaving a loop or a function'")}) ${text(consequent)}${alternate ? ` else ${text(alternate)}` : ''}`
    const block = (statement: Tree | null) =>
      !statement
        ? '{}'
        : statement.type === 'BlockStatement'
          ? text(statement)
          : `{${text(statement)}}`
    const names = [...assignedIn([consequent, alternate].filter(Boolean))]
    return `${op('branch', text(test), `() => ${block(consequent)}`, `() => ${block(alternate)}`, `() => [${names.join(', ')}]`, `(warpjetValues) => { [${names.join(', ')}] = warpjetValues }`)};`
  }

  return text(tree)
}

/** Whether a statement such as `return` is in it, but not in a function of its own. */
function leaves(node: Tree, type: string): boolean {
  let found = false
  walk(node, (each) => {
    if (each.type === type) found = true
    const isLoop =
      /^(For|While|DoWhile)/.test(each.type) && type !== 'ReturnStatement' && each !== node
    return !/Function/.test(each.type) && !isLoop
  })
  return found
}

function endsInReturn(node: Tree): boolean {
  if (node.type === 'ReturnStatement' || node.type === 'ThrowStatement') return true
  if (node.type === 'BlockStatement') return node.body.length > 0 && endsInReturn(node.body.at(-1))
  return (
    node.type === 'IfStatement' &&
    !!node.alternate &&
    endsInReturn(node.consequent) &&
    endsInReturn(node.alternate)
  )
}

/** In the order of the text. */
export const childrenOf = (node: Tree): Tree[] =>
  Object.values(node)
    .flat()
    .filter(
      (value): value is Tree =>
        !!value && typeof value === 'object' && typeof value.type === 'string',
    )
    .filter(
      (value, i, all) =>
        all.findIndex((other) => other.start === value.start && other.end === value.end) === i,
    )
    .sort((a, b) => a.start - b.start)
