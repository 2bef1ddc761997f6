// Analyses which names a function declares, and which it assigns.
import type { Tree } from './tree.js'

/** Visits a tree from the top; `visit` returns false to skip the children of a node. */
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

/** Returns the names that a pattern such as `{ position: p, ...rest }` binds. */
export function namesBoundBy(pattern: Tree | null): string[] {
  switch (pattern?.type) {
    case 'Identifier':
      return [pattern.name as string]
    case 'ObjectPattern':
      return pattern.properties.flatMap((each: Tree) => namesBoundBy(each.value ?? each.argument))
    case 'ArrayPattern':
      return pattern.elements.flatMap(namesBoundBy)
    case 'AssignmentPattern':
      return namesBoundBy(pattern.left)
    case 'RestElement':
      return namesBoundBy(pattern.argument)
    default:
      return []
  }
}

/** Returns all names that are declared anywhere in a tree. */
export function declaredIn(tree: Tree): Set<string> {
  const names = new Set<string>()
  walk(tree, (node) => {
    if (node.type === 'VariableDeclarator')
      for (const name of namesBoundBy(node.id)) names.add(name)
    if (/Function|Class/.test(node.type) && node.id) names.add(node.id.name)
    if (/Function/.test(node.type))
      for (const parameter of node.params ?? [])
        for (const name of namesBoundBy(parameter)) names.add(name)
    if (node.type === 'CatchClause') for (const name of namesBoundBy(node.param)) names.add(name)
    if (/^Import\w*Specifier$/.test(node.type)) names.add(node.local.name)
  })
  return names
}

/** Returns the variables that statements assign and that are declared outside these statements. */
export function assignedIn(trees: Tree[]): Set<string> {
  const names = new Set<string>()
  const visit = (node: Tree, outer: Set<string>) => {
    const bound = scopeOf(node)
    const inner = bound.length ? new Set([...outer, ...bound]) : outer
    for (const name of targetsOf(node).flatMap(namesBoundBy)) if (!inner.has(name)) names.add(name)
    for (const child of Object.values(node).flat())
      if (child && typeof child === 'object' && typeof child.type === 'string') visit(child, inner)
  }
  const declared = new Set([
    ...trees.flatMap(namesDeclaredBy),
    ...trees.flatMap((tree) => varsIn(tree)),
  ])
  for (const tree of trees) visit(tree, declared)
  return names
}

/** Returns the targets of the assignment that a node makes. */
function targetsOf({ type, left, argument }: Tree): Tree[] {
  if (type === 'AssignmentExpression') return [left]
  if (type === 'UpdateExpression') return [argument]
  return /^For(In|Of)/.test(type) && left.type !== 'VariableDeclaration' ? [left] : []
}

/** Returns the first property that statements assign, such as `v.y`. */
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

/** Returns the names that a statement declares in its block. */
function namesDeclaredBy(statement: Tree | null): string[] {
  if (statement?.type === 'VariableDeclaration')
    return statement.declarations.flatMap(({ id }: Tree) => namesBoundBy(id))
  return /^(Function|Class)Declaration$/.test(statement?.type ?? '')
    ? namesBoundBy(statement!.id)
    : []
}

/** Returns the names that a statement at the top of a module declares, exported or not. */
const declaredInModule = (statement: Tree): string[] =>
  /^Export(Named|Default)Declaration$/.test(statement.type) && statement.declaration
    ? namesDeclaredBy(statement.declaration)
    : namesDeclaredBy(statement)

const importedIn = (program: Tree): string[] =>
  program.body
    .filter(({ type }: Tree) => type === 'ImportDeclaration')
    .flatMap(({ specifiers }: Tree) => specifiers.map(({ local }: Tree) => local.name))

/** Returns the names of `var` declarations, which have function scope; `withLoops` includes those in the heads of loops. */
export function varsIn(tree: Tree, withLoops: unknown = true): string[] {
  const names: string[] = []
  walk(tree, (node, parent) => {
    if (/Function/.test(node.type)) return false
    const isInLoopHead = /^For/.test(parent?.type ?? '') && node !== parent!.body
    if (node.type === 'VariableDeclaration' && node.kind === 'var' && (withLoops || !isInLoopHead))
      names.push(...namesDeclaredBy(node))
    return true
  })
  return names
}

/** Returns the names that a node binds, whose scope is the node. */
export function scopeOf(node: Tree): string[] {
  if (node.type === 'Program')
    return [...node.body.flatMap(declaredInModule), ...varsIn(node), ...importedIn(node)]
  if (node.type === 'StaticBlock') return [...node.body.flatMap(namesDeclaredBy), ...varsIn(node)]
  if (/Function/.test(node.type))
    return [...node.params.flatMap(namesBoundBy), ...namesBoundBy(node.id), ...varsIn(node.body)]
  if (/^For/.test(node.type)) return namesDeclaredBy(node.init ?? node.left ?? null)
  if (node.type === 'BlockStatement') return node.body.flatMap(namesDeclaredBy)
  if (node.type === 'SwitchStatement')
    return node.cases.flatMap(({ consequent }: Tree) => consequent.flatMap(namesDeclaredBy))
  return node.type === 'CatchClause' ? namesBoundBy(node.param) : []
}

/** Returns whether an identifier is the name of a property or of a label. */
export const isProperty = (node: Tree, parent?: Tree): boolean =>
  (parent?.type === 'MemberExpression' && parent.property === node && !parent.computed) ||
  (/^(Property|MethodDefinition|PropertyDefinition)$/.test(parent?.type ?? '') &&
    parent!.key === node &&
    !parent!.computed &&
    !parent!.shorthand) ||
  /^(Labeled|Break|Continue)Statement$/.test(parent?.type ?? '')
