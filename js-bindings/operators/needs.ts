// Decides whether a function contains anything to translate; otherwise it stays unchanged. Operators on values that cannot be
// expressions, such as the counter of a loop, stay JavaScript's.
import { isKnown } from './functions.js'
import { freeReferences } from './resolve.js'
import { namesBoundBy, walk } from './scopes.js'
import { isOperator } from './symbols.js'
import { childrenOf, type Tree } from './tree.js'

/**
 * What a function uses: `operators` on possible expressions, which would throw or mean something else without translation; or only
 * `logic`, such as `sum ? sum.add(x) : x`, where JavaScript tests whether the value exists.
 */
export type Needs = 'operators' | 'logic' | 'nothing'

export function needsOf(tree: Tree, { isHelper = false } = {}): Needs {
  const references = freeReferences(tree)
  const free = new Set([...references.values()].flat())
  // A helper may read a variable of the sketch to which the offset function has assigned an expression.
  const mayBeExpression = expressionsIn(tree, isHelper ? [...references.keys()] : [])
  const setsOthers = hasNode(
    tree,
    ({ type, left }) => type === 'AssignmentExpression' && free.has(rootOf(left)),
  )
  let needs: Needs = 'nothing'
  walk(tree, (node) => {
    if (needs === 'operators') return false
    if (isExistenceTest(node)) return true
    if (isLogic(node)) {
      if (conditionsOf(node).some(mayBeExpression)) needs = 'logic'
    } else if (
      (isOperator(node) && childrenOf(node).some(mayBeExpression)) ||
      isCallToTranslate(node, free, setsOthers ? () => true : mayBeExpression)
    )
      needs = 'operators'
    return true
  })
  return needs
}

function hasNode(tree: Tree, test: (node: Tree) => boolean): boolean {
  let found = false
  walk(tree, (node) => {
    found ||= test(node)
    return !found
  })
  return found
}

const isLogic = ({ type, operator }: Tree): boolean =>
  /^(LogicalExpression|ConditionalExpression|(If|While|DoWhile|For|Switch)Statement)$/.test(type) ||
  (type === 'UnaryExpression' && operator === '!') ||
  (type === 'AssignmentExpression' && /^(&&|\|\|)=$/.test(operator))

/** Recognizes `x == null` and similar comparisons, which ask whether a value exists. */
const isExistenceTest = ({ type, operator, left, right }: Tree): boolean =>
  type === 'BinaryExpression' &&
  /^[!=]==?$/.test(operator) &&
  [left, right].some(
    (each: Tree) =>
      each.name === 'undefined' ||
      (each.type === 'Literal' && (each.value === null || typeof each.value === 'string')),
  )

const conditionsOf = ({ test, discriminant, argument, left }: Tree): Tree[] =>
  [test, discriminant, argument, left].filter((each) => !!each)

/** Recognizes JavaScript's own names, whose functions no sketch defines. */
const isBuiltIn = (name: string) =>
  /^(console|Math|JSON|Object|Array|Number|String|Boolean|Symbol|BigInt|Map|Set|WeakMap|Date|RegExp|Promise|Reflect|Proxy|Intl|Error|\w+Error|\w+Array|performance|document|window|globalThis|parseInt|parseFloat|isNaN|isFinite)$/.test(
    name,
  )

const rootOf = (node: Tree): Tree =>
  node.type === 'MemberExpression' || node.type === 'CallExpression'
    ? rootOf(node.object ?? node.callee)
    : node

/** Returns whether a node calls a known function of numbers, or a function of the sketch that may contain operators. */
function isCallToTranslate(
  { type, callee, arguments: values }: Tree,
  free: ReadonlySet<Tree>,
  mayBeExpression: (node: Tree) => boolean,
): boolean {
  if (type !== 'CallExpression' && type !== 'NewExpression') return false
  const root = rootOf(callee)
  const name: string = callee.name ?? callee.property?.name ?? ''
  if (root.type === 'ThisExpression') return true
  if (root.type !== 'Identifier' || !free.has(root)) return false
  // An argument that is a function may use expressions that are not passed.
  const getsExpression =
    mayBeExpression(callee) ||
    values.some((each: Tree) => mayBeExpression(each) || /Function/.test(each.type))
  return getsExpression && (isBuiltIn(root.name) ? root.name === 'Math' && isKnown(name) : true)
}

/**
 * Returns a function that checks whether the value of a node may be an expression. The check ignores the order of statements. `outerNames`
 * are variables around the tree that may hold expressions.
 */
function expressionsIn(tree: Tree, outerNames: readonly string[]): (node: Tree) => boolean {
  const names = new Set(['arguments', ...outerNames.filter((name) => !isBuiltIn(name))])
  const functions = new Set<string>()
  walk(tree, (node) => {
    if (/Function/.test(node.type)) {
      for (const parameter of node.params)
        for (const name of namesBoundBy(parameter)) names.add(name)
      if (node.id) functions.add(node.id.name)
    }
    if (node.type === 'VariableDeclarator' && /Function/.test(node.init?.type ?? ''))
      functions.add(node.id.name)
  })

  function mayBe(node: Tree): boolean {
    switch (node.type) {
      case 'Literal':
      case 'TemplateLiteral':
      case 'ClassExpression':
      case 'FunctionExpression':
      case 'ArrowFunctionExpression':
        return false
      case 'Identifier':
        return names.has(node.name)
      case 'ThisExpression':
      case 'Super':
        return true
      case 'MemberExpression':
        return mayBe(node.object)
      case 'UnaryExpression':
        return node.operator !== 'typeof' && mayBe(node.argument)
      case 'CallExpression':
        return functions.has(node.callee.name) || [node.callee, ...node.arguments].some(mayBe)
      case 'Property':
        return mayBe(node.value)
      default:
        return childrenOf(node).some(mayBe)
    }
  }

  const set = (target: Tree) => {
    const all =
      target.type === 'MemberExpression' ? [rootOf(target).name as string] : namesBoundBy(target)
    for (const name of all) names.add(name)
  }
  for (let sizeBefore = -1; sizeBefore !== names.size;) {
    sizeBefore = names.size
    walk(tree, (node) => {
      if (node.type === 'VariableDeclarator' && node.init && mayBe(node.init)) set(node.id)
      if (node.type === 'AssignmentExpression' && mayBe(node.right)) set(node.left)
      if (/^For(In|Of)/.test(node.type) && mayBe(node.right))
        set(node.left.type === 'VariableDeclaration' ? node.left.declarations[0].id : node.left)
    })
  }
  return mayBe
}

/** Returns whether a function returns an array, which we convert to a vector. */
export function returnsArray(tree: Tree): boolean {
  let found = tree.body?.type === 'ArrayExpression'
  walk(tree, ({ type, argument, body }) => {
    found ||= type === 'ReturnStatement' && argument?.type === 'ArrayExpression'
    found ||= type === 'ArrowFunctionExpression' && body.type === 'ArrayExpression'
    return !found
  })
  return found
}
