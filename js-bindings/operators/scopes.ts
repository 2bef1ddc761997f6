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
function bound(pattern: Tree | null): string[] {
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
  })
  return names
}

/** The variables from outside of them that statements set. */
export function assignedIn(trees: Tree[]): Set<string> {
  const own = new Set(trees.flatMap((tree) => [...declaredIn(tree)]))
  const names = new Set<string>()
  for (const tree of trees)
    walk(tree, (node) => {
      if (node.type === 'AssignmentExpression') for (const name of bound(node.left)) names.add(name)
      if (node.type === 'UpdateExpression') for (const name of bound(node.argument)) names.add(name)
    })
  return new Set([...names].filter((name) => !own.has(name)))
}

/** The names that it takes from around it. */
export function freeIn(tree: Tree): Set<string> {
  const own = declaredIn(tree)
  const names = new Set<string>()
  walk(tree, (node, parent) => {
    if (node.type !== 'Identifier' || own.has(node.name as string)) return
    const isProperty =
      (parent?.type === 'MemberExpression' && parent.property === node && !parent.computed) ||
      (/^(Property|MethodDefinition|PropertyDefinition)$/.test(parent?.type ?? '') &&
        parent!.key === node &&
        !parent!.computed &&
        !parent!.shorthand) ||
      /^(Labeled|Break|Continue)Statement$/.test(parent?.type ?? '')
    if (!isProperty) names.add(node.name as string)
  })
  names.delete('undefined')
  names.delete('arguments')
  return names
}
