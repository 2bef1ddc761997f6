// Names in the text of a function: which it declares, which it sets, and which it takes from around it.
import type { Tree } from './tree.js'

/** Visits a tree from the top; `visit` returns false to leave out what is in a node. */
export function walk(
  node: Tree,
  visit: (node: Tree, parent?: Tree) => boolean | void,
  parent?: Tree,
) {
  if (visit(node, parent) === false) return
  for (const value of Object.values(node).flat())
    if (value && typeof value === 'object' && typeof (value as Tree).type === 'string')
      walk(value as Tree, visit, node)
}

/** The names that a pattern binds, such as `{ position: p, ...rest }`. */
export function bound(pattern: Tree | null): string[] {
  switch (pattern?.type) {
    case 'Identifier':
      return [pattern.name as string]
    case 'ObjectPattern':
      return pattern.properties.flatMap((each: Tree) => bound(each.value ?? each.argument))
    case 'ArrayPattern':
      return pattern.elements.flatMap(bound)
    case 'AssignmentPattern':
      return bound(pattern.left)
    case 'RestElement':
      return bound(pattern.argument)
    default:
      return []
  }
}

/** All names that are declared anywhere in it. */
export function declaredIn(tree: Tree): Set<string> {
  const names = new Set<string>()
  walk(tree, (node) => {
    if (node.type === 'VariableDeclarator') for (const name of bound(node.id)) names.add(name)
    if (/Function|Class/.test(node.type) && node.id) names.add(node.id.name)
    if (/Function/.test(node.type))
      for (const parameter of node.params ?? [])
        for (const name of bound(parameter)) names.add(name)
    if (node.type === 'CatchClause') for (const name of bound(node.param)) names.add(name)
    if (/^Import\w*Specifier$/.test(node.type)) names.add(node.local.name)
  })
  return names
}

/** The variables from outside of them that statements set. */
export function assignedIn(trees: Tree[]): Set<string> {
  const names = new Set<string>()
  const visit = (node: Tree, around: Set<string>) => {
    const here = scopeOf(node)
    const own = here.length ? new Set([...around, ...here]) : around
    for (const name of targetsOf(node).flatMap(bound)) if (!own.has(name)) names.add(name)
    for (const child of Object.values(node).flat())
      if (child && typeof child === 'object' && typeof child.type === 'string') visit(child, own)
  }
  const around = new Set([...trees.flatMap(declared), ...trees.flatMap((tree) => varsIn(tree))])
  for (const tree of trees) visit(tree, around)
  return names
}

/** What a node sets. */
function targetsOf({ type, left, argument }: Tree): Tree[] {
  if (type === 'AssignmentExpression') return [left]
  if (type === 'UpdateExpression') return [argument]
  return /^For(In|Of)/.test(type) && left.type !== 'VariableDeclaration' ? [left] : []
}

/** The first property that statements set, such as `v.y`. */
export function propertySetIn(trees: Tree[]): Tree | undefined {
  let found: Tree | undefined
  const inPattern = (target: Tree | null) => {
    if (target?.type === 'MemberExpression') found ??= target
    else if (target?.type === 'ObjectPattern')
      for (const each of target.properties) inPattern(each.value ?? each.argument)
    else if (target?.type === 'ArrayPattern') target.elements.forEach(inPattern)
    else if (target?.type === 'AssignmentPattern') inPattern(target.left)
    else if (target?.type === 'RestElement') inPattern(target.argument)
  }
  for (const tree of trees)
    walk(tree, (node) => {
      targetsOf(node).forEach(inPattern)
      if (node.type === 'UnaryExpression' && node.operator === 'delete') inPattern(node.argument)
    })
  return found
}

/** The names that one statement declares, for those beside it. */
function declared(statement: Tree | null): string[] {
  if (statement?.type === 'VariableDeclaration')
    return statement.declarations.flatMap(({ id }: Tree) => bound(id))
  return /^(Function|Class)Declaration$/.test(statement?.type ?? '') ? bound(statement!.id) : []
}

/** The names that a statement at the top of a module declares, exported or not. */
const declaredInModule = (statement: Tree): string[] =>
  /^Export(Named|Default)Declaration$/.test(statement.type) && statement.declaration
    ? declared(statement.declaration)
    : declared(statement)

const importedIn = (program: Tree): string[] =>
  program.body
    .filter(({ type }: Tree) => type === 'ImportDeclaration')
    .flatMap(({ specifiers }: Tree) => specifiers.map(({ local }: Tree) => local.name))

/** The names of `var` in it, which its blocks do not hold; without a loop's own, which are read in the loop. */
export function varsIn(tree: Tree, withLoops: unknown = true): string[] {
  const names: string[] = []
  walk(tree, (node, parent) => {
    if (/Function/.test(node.type)) return false
    const isOfLoop = /^For/.test(parent?.type ?? '') && node !== parent!.body
    if (node.type === 'VariableDeclaration' && node.kind === 'var' && (withLoops || !isOfLoop))
      names.push(...declared(node))
    return true
  })
  return names
}

/** The names that hold within a node alone. */
export function scopeOf(node: Tree): string[] {
  if (node.type === 'Program')
    return [...node.body.flatMap(declaredInModule), ...varsIn(node), ...importedIn(node)]
  if (node.type === 'StaticBlock') return [...node.body.flatMap(declared), ...varsIn(node)]
  if (/Function/.test(node.type))
    return [...node.params.flatMap(bound), ...bound(node.id), ...varsIn(node.body)]
  if (/^For/.test(node.type)) return declared(node.init ?? node.left ?? null)
  if (node.type === 'BlockStatement') return node.body.flatMap(declared)
  if (node.type === 'SwitchStatement')
    return node.cases.flatMap(({ consequent }: Tree) => consequent.flatMap(declared))
  return node.type === 'CatchClause' ? bound(node.param) : []
}

/** Whether an identifier is the name of a property or of a label. */
export const isProperty = (node: Tree, parent?: Tree): boolean =>
  (parent?.type === 'MemberExpression' && parent.property === node && !parent.computed) ||
  (/^(Property|MethodDefinition|PropertyDefinition)$/.test(parent?.type ?? '') &&
    parent!.key === node &&
    !parent!.computed &&
    !parent!.shorthand) ||
  /^(Labeled|Break|Continue)Statement$/.test(parent?.type ?? '')
