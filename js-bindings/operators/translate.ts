// From the text of a function, whose operators work on numbers, to one whose operators ask what they work on. Lines stay where
// they are, so that errors name the sketch's own.
import { shorten } from '../checks/describe.js'
import { functionNames } from './runtime.js'
import { assignedIn, declaredIn, isProperty, propertySetIn, varsIn, walk } from './scopes.js'
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
  '==': 'looseEq',
  '===': 'eq',
  '!=': 'looseNe',
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
  /** What the function that is being translated declares. */
  let declaredHere = new Set<string>()
  let rests = 0

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
              operand(node.left),
              between(node.left, node.right) + operand(node.right),
            )
          : undefined
      case 'UnaryExpression':
        return unary[node.operator] && node.argument.type !== 'Literal'
          ? op(unary[node.operator]!, operand(node.argument))
          : undefined
      case 'LogicalExpression':
        return logical[node.operator]
          ? op(
              logical[node.operator]!,
              unlessSetting(node.left, [node.right]),
              `${between(node.left, node.right)}() => ${operand(node.right)}`,
            )
          : undefined
      case 'ConditionalExpression':
        return op(
          'choose',
          unlessSetting(node.test, [node.consequent, node.alternate]),
          `${between(node.test, node.consequent)}() => ${operand(node.consequent)}`,
          `${between(node.consequent, node.alternate)}() => ${operand(node.alternate)}`,
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
        return `{${statements(node.body, node.start + 1, node.end - 1, endsFunction(node) ? { then: '', following: [] } : undefined)}}`
      case 'IfStatement':
        return onItsLines(node, branch(node))
      case 'WhileStatement':
      case 'DoWhileStatement':
      case 'ForStatement':
        return loop(node)
      case 'SwitchStatement':
        return `${source.slice(node.start, node.discriminant.start)}${op('decided', operand(node.discriminant), "'A switch'")}${pieces(node.discriminant.end, node.end, node.cases)}`
      case 'FunctionDeclaration':
      case 'FunctionExpression':
      case 'ArrowFunctionExpression':
        return ofFunction(node)
      default:
        return undefined
    }
  }

  /** What a function's body returns early is chosen by vertex. */
  function ofFunction(node: Tree): string | undefined {
    if (node.body.type !== 'BlockStatement') return undefined
    const around = declaredHere
    declaredHere = declaredIn(node)
    const { start, end, body } = node.body
    const result = `${pieces(node.start, start, childrenOf(node).slice(0, -1))}{${statements(body, start + 1, end - 1, { then: '', following: [] })}}`
    declaredHere = around
    return result
  }

  function assignment({ operator, left, right }: Tree): string | undefined {
    const symbol = operator.slice(0, -1)
    const name = binary[symbol] ?? logical[symbol]
    if (operator === '=' || !name) return undefined
    const changed = (target: string) =>
      logical[symbol]
        ? op(name, unlessSetting(target, [right]), `${between(left, right)}() => ${operand(right)}`)
        : op(name, target, between(left, right) + operand(right))
    if (isSteady(left)) return `${text(left)} = ${changed(text(left))}`
    const { object, property, computed } = left
    if (property.type === 'PrivateIdentifier') return undefined
    return op(
      'change',
      operand(object),
      computed ? operand(property) : `'${property.name}'`,
      `(warpjetValue) => ${changed('warpjetValue')}`,
    )
  }

  /** Its value is not read. Without parentheses, which would call what stands on the line before. */
  function statement({ expression }: Tree): string | undefined {
    const { type, argument, operator } = expression
    if (type === 'UpdateExpression' && argument.type === 'Identifier')
      return `${argument.name} = ${op(operator === '++' ? 'add' : 'sub', argument.name, '1')};`
    const assigned = type === 'AssignmentExpression' && assignment(expression)
    if (type === 'SequenceExpression') return `0, ${text(expression)};`
    return assigned ? `${assigned};` : undefined
  }

  /** As an argument, or after `=>`: the parentheses around a node are no part of it. */
  const operand = (node: Tree) =>
    node.type === 'SequenceExpression' || source[node.start] === '{'
      ? `(${text(node)})`
      : text(node)

  /** A condition for operands of which one alone may be computed, where they set something. */
  function unlessSetting(condition: Tree | string, operands: Tree[]) {
    const translated = typeof condition === 'string' ? condition : operand(condition)
    const property = propertySetIn(operands)
    const [name] = property ? [nameOf(property)] : assignedIn(operands)
    return name ? op('decided', translated, setting(name)) : translated
  }

  const nameOf = (node: Tree) => shorten(source.slice(node.start, node.end))
  const setting = (name: string) => JSON.stringify(`Setting ${name} here`)

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
      ...given.map(
        (each: Tree, i: number) => (i ? between(given[i - 1], each) : '') + operand(each),
      ),
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
      return `${pieces(node.start, node.test.start, [node.body])}${op('decided', operand(node.test), "'A loop'")}${source.slice(node.test.end, node.end)}`
    const rest = node.update ? [node.update, node.body] : [node.body]
    return `${start}${op('decided', operand(node.test), "'A loop'")}${pieces(node.test.end, node.end, rest)}`
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

  /**
   * Statements in order. Where they are the last that a function does, but for `tail`, and an `if` returns, the rest of them is
   * what happens otherwise.
   */
  function statements(list: Tree[], start: number, end: number, tail?: Tail): string {
    let result = ''
    let at = start
    for (const [i, node] of list.entries()) {
      result += source.slice(at, node.start)
      if (tail && node.type === 'IfStatement' && leaves(node, 'ReturnStatement')) {
        const later = list.slice(i + 1)
        const following = [later, ...tail.following]
        if (!onlyDecided(node, following))
          return result + returning(node, statements(later, node.end, end, tail), following)
      }
      result += text(node)
      at = node.end
    }
    return `${result}${source.slice(at, end)}${tail?.then ?? ''}`
  }

  /** Whether what an `if` does cannot be undone, where it returns by vertex: then JavaScript has to decide it. */
  function onlyDecided(node: Tree, following: Tree[][]): boolean {
    const { consequent, alternate } = node
    const first = endsInReturn(consequent) ? [] : following.flat()
    const all = [[consequent], alternate ? [alternate] : [], ...following]
    return (
      !!propertySetIn([consequent, ...first]) ||
      namesSetIn(all).some((name) => !declaredHere.has(name)) ||
      !!escaping(node)
    )
  }

  const namesSetIn = (groups: Tree[][]) => [
    ...new Set(groups.flatMap((group) => [...assignedIn(group)])),
  ]

  /** A `var` in an `if` that is read outside of it. */
  const escaping = (node: Tree): string | undefined =>
    varsIn(node, false).find((name) => {
      let isFound = false
      walk(tree, (each, parent) => {
        isFound ||= each.type === 'Identifier' && each.name === name && !isProperty(each, parent)
        return each !== node
      })
      return isFound
    })

  /** `if (c) return a; rest`: by vertex, where both a and the rest are values. */
  function returning(
    { test, consequent, alternate }: Tree,
    rest: string,
    following: Tree[][],
  ): string {
    const name = `warpjetRest${++rests}`
    const block = (node: Tree | null) => {
      const then = node && endsInReturn(node) ? '' : `; return ${name}();`
      if (!node) return then
      const tail = { then, following: then ? following : [] }
      return node.type === 'BlockStatement'
        ? statements(node.body, node.start + 1, node.end - 1, tail)
        : statements([node], node.start, node.end, tail)
    }
    const ways = [consequent, alternate].filter(Boolean)
    const isRest = ways.length < 2 || !ways.every(endsInReturn)
    const names = namesSetIn([...ways.map((way) => [way]), ...following])
    return (
      (isRest ? `const ${name} = () => {${rest}\n};` : '').replaceAll(/\n(?=\};$)/g, ' ') +
      `return ${op('choose', operand(test), `() => {${block(consequent)}}`, `() => {${block(alternate)}}`, ...(names.length ? variables(names) : []))}`
    )
  }

  /** A call whose value nobody takes, so that it stands there for what it does. */
  const effectIn = (ways: Tree[]): string[] => {
    let found: Tree | undefined
    for (const way of ways)
      walk(way, (node) => {
        if (node.type === 'ExpressionStatement' && node.expression.type === 'CallExpression')
          found ??= node.expression
        return !/Function/.test(node.type)
      })
    return found ? [JSON.stringify(nameOf(found))] : []
  }

  const variables = (names: string[]) => [
    `() => [${names.join(', ')}]`,
    `(warpjetValues) => { [${names.join(', ')}] = warpjetValues }`,
  ]

  function branch(node: Tree): string {
    const { test, consequent, alternate } = node
    const block = (statement: Tree | null) =>
      !statement
        ? '{}'
        : statement.type === 'BlockStatement'
          ? text(statement)
          : `{${text(statement)}}`
    const ways = [consequent, alternate].filter(Boolean)
    const property = propertySetIn(ways)
    const name = property ? nameOf(property) : escaping(node)
    const isLeft = ['BreakStatement', 'ContinueStatement', 'ReturnStatement'].some((type) =>
      leaves(node, type),
    )
    if (isLeft || name) {
      const what = name ? setting(name) : "'Leaving a loop or a function here'"
      return `if (${op('decided', operand(test), what)}) ${block(consequent)}${alternate ? ` else ${block(alternate)}` : ''}`
    }
    const names = namesSetIn(ways.map((way) => [way]))
    return `${op('branch', operand(test), `() => ${block(consequent)}`, `() => ${block(alternate)}`, ...variables(names), ...effectIn(ways))};`
  }

  return text(tree)
}

/** What comes after statements: text, and the statements that it stands for, by the block that they are in. */
interface Tail {
  then: string
  following: Tree[][]
}

/** Whether reading it twice is reading it once. */
const isSteady = (node: Tree): boolean =>
  node.type === 'MemberExpression'
    ? isSteady(node.object) && (!node.computed || isSteady(node.property))
    : /^(Identifier|Literal|ThisExpression|Super)$/.test(node.type)

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

/** Whether nothing comes after a block, within a loop neither. */
const endsFunction = (block: Tree): boolean =>
  endsInReturn(block) && !leaves(block, 'BreakStatement') && !leaves(block, 'ContinueStatement')

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
