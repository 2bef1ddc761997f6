// From the text of a function, whose operators work on numbers, to one whose operators ask what they work on. Lines stay where
// they are, so that errors name the sketch's own.
import { shorten } from '../errors/describe.js'
import {
  changesVector,
  endsFunction,
  endsInReturn,
  functionNamesIn,
  isSteady,
  isSuspended,
  leaves,
} from './flow.js'
import { isKnown } from './functions.js'
import { assignedIn, declaredIn, isProperty, propertySetIn, varsIn, walk } from './scopes.js'
import { childrenOf, type Tree } from './tree.js'

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
const bits = new Set(['|', '&', '^', '<<', '>>', '>>>'])
const unary: Record<string, string> = { '-': 'neg', '+': 'plus', '!': 'not' }
const logical: Record<string, string> = { '&&': 'and', '||': 'or' }

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

export interface Translation {
  /** Returns whether an identifier is bound outside of the function. */
  isFree: (node: Tree) => boolean
  /** The name of the operators in the translated text. */
  operatorsName: string
  /** True if other functions are translated when they are called. */
  readsHelpers: boolean
  /** Variables that hold functions of Math. */
  aliases?: ReadonlySet<string>
}

/** The text of `tree`, part of `source`, translated. */
export function translate(
  source: string,
  tree: Tree,
  { isFree, operatorsName, readsHelpers, aliases }: Translation,
): string {
  const op = (name: string, ...operands: string[]) =>
    `${operatorsName}.${name}(${operands.join(', ')})`
  const valueName = unusedName('warpjetValue', source)
  const restName = unusedName('warpjetRest', source)
  /** What the function that is being translated declares. */
  let declaredHere = new Set<string>()
  let rests = 0
  const functionsHere = functionNamesIn(tree)
  /** Calls in a chain such as `a?.b.c()`, which may be left out. */
  const optional = new Set<Tree>()

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
        return binaryOf(
          node.operator,
          operand(node.left),
          between(node.left, node.right) + operand(node.right),
        )
      case 'UnaryExpression':
        return unaryOf(node)
      case 'LogicalExpression':
        if (!logical[node.operator]) return undefined
        if (isSuspended([node.right]))
          return `(${op('decided', operand(node.left), "'yield or await here'")} ${node.operator}${between(node.left, node.right)} ${text(node.right)})`
        return op(
          logical[node.operator]!,
          unlessSetting(node.left, [node.right]),
          `${between(node.left, node.right)}() => ${operand(node.right)}`,
        )
      case 'ConditionalExpression':
        if (isSuspended([node.consequent, node.alternate]))
          return `(${op('decided', operand(node.test), "'yield or await here'")} ? ${between(node.test, node.consequent)}${operand(node.consequent)} : ${between(node.consequent, node.alternate)}${operand(node.alternate)})`
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
      case 'ChainExpression':
        for (let each: Tree = node.expression; each; each = each.callee ?? each.object)
          optional.add(each)
        return undefined
      case 'CallExpression':
        return optional.has(node) ? undefined : translateCall(node)
      case 'NewExpression':
        return translateNew(node)
      case 'UpdateExpression':
        return translateUpdate(node, false)
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

  const binaryOf = (operator: string, left: string, right: string) =>
    binary[operator]
      ? op(binary[operator]!, left, right)
      : bits.has(operator)
        ? op('bits', `'${operator}'`, left, right)
        : undefined

  function unaryOf({ operator, argument }: Tree): string | undefined {
    if (argument.type === 'Literal') return undefined
    if (operator !== '~') return unary[operator] && op(unary[operator]!, operand(argument))
    // ~~x, which cuts off the fraction.
    return argument.type === 'UnaryExpression' && argument.operator === '~'
      ? op('bits', "'|'", operand(argument.argument), '0')
      : op('bits', "'^'", operand(argument), '-1')
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
    if (operator === '=' || isSuspended([right])) return undefined
    if (!binary[symbol] && !logical[symbol] && !bits.has(symbol)) return undefined
    const changed = (target: string) =>
      logical[symbol]
        ? op(
            logical[symbol]!,
            unlessSetting(target, [right]),
            `${between(left, right)}() => ${operand(right)}`,
          )
        : binaryOf(symbol, target, between(left, right) + operand(right))!
    if (isSteady(left)) return `${text(left)} = ${changed(text(left))}`
    const { object, property, computed } = left
    if (property.type === 'PrivateIdentifier' || object.type === 'Super') return undefined
    return op(
      'change',
      operand(object),
      computed ? operand(property) : `'${property.name}'`,
      `(${valueName}) => ${changed(valueName)}`,
    )
  }

  /** `x++` and its like. */
  function translateUpdate(
    { argument, operator, prefix }: Tree,
    isUnused: boolean,
  ): string | undefined {
    const by = operator === '++' ? '1' : '-1'
    if (argument.type === 'Identifier') {
      const set = `${argument.name} = ${op('move', argument.name, by)}`
      if (isUnused) return set
      return prefix ? `(${set})` : op('first', argument.name, set)
    }
    const { object, property, computed } = argument
    if (property.type === 'PrivateIdentifier' || object.type === 'Super') return undefined
    return op(
      prefix || isUnused ? 'change' : 'changeAfter',
      operand(object),
      computed ? operand(property) : `'${property.name}'`,
      `(${valueName}) => ${op('move', valueName, by)}`,
    )
  }

  /** Its value is not read. Without parentheses, which would call what stands on the line before. */
  function statement({ expression }: Tree): string | undefined {
    const { type } = expression
    if (type === 'UpdateExpression') {
      const set = translateUpdate(expression, true)
      return set && `${set};`
    }
    if (type === 'CallExpression' && changesVector(expression))
      return `${op('unused', text(expression), JSON.stringify(nameOf(expression)))};`
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

  const argumentsOf = (callee: Tree, given: Tree[]) =>
    given.map((each, i) => between(given[i - 1] ?? callee, each) + operand(each))

  function translateCall(node: Tree): string | undefined {
    const { callee, arguments: given } = node
    const all = argumentsOf(callee, given)
    const onLines = (translated: string) => onItsLines(node, translated)
    if (callee.type === 'Identifier') {
      const { name } = callee
      if (name === 'eval') return undefined
      if (isFree(callee) && (readsHelpers || isKnown(name)))
        return onLines(op('call', `'${name}'`, `() => ${name}`, ...all))
      return (readsHelpers || aliases?.has(name)) && !isFree(callee) && !functionsHere.has(name)
        ? onLines(op('invoke', name, 'undefined', ...all))
        : undefined
    }
    if (callee.type !== 'MemberExpression') return undefined
    const { object, property, computed } = callee
    if (object.type === 'Super' || property.type === 'PrivateIdentifier') return undefined
    if (!readsHelpers && (computed || !isKnown(property.name))) return undefined
    if (object.name === 'Math' && !computed && isKnown(property.name) && isFree(object))
      return onLines(op('call', `'${property.name}'`, `() => Math.${property.name}`, ...all))
    const key = computed ? operand(property) : `'${property.name}'`
    return onLines(op('method', operand(object), between(object, property) + key, ...all))
  }

  function translateNew(node: Tree): string | undefined {
    const { callee, arguments: given } = node
    return readsHelpers && callee.type === 'Identifier'
      ? onItsLines(node, op('construct', callee.name, ...argumentsOf(callee, given)))
      : undefined
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
      isSuspended(all.flat()) ||
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
    const name = `${restName}${++rests}`
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
    `(${valueName}) => { [${names.join(', ')}] = ${valueName} }`,
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
    if (isLeft || name || isSuspended(ways)) {
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
