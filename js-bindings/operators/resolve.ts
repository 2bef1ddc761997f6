// Scope analysis: the free names of a function, and the names that are bound around it.
import { isProperty, namesBoundBy, scopeOf } from './scopes.js'
import type { Tree } from './tree.js'

/** The names that are bound by the scopes that enclose a node. */
interface EnclosingScopes {
  names: readonly ReadonlySet<string>[]
  /** True if `this` and `new.target` at the node belong to a function or class within the tree. */
  ownsThis: boolean
  ownsArguments: boolean
  privates: ReadonlySet<string>
}

/** Maps a name to the nodes that read or set it. Pseudo-names are `this`, `arguments`, `super`, `new.target` and `#private`. */
export type References = Map<string, Tree[]>

/** Returns the references in `tree` to names that it does not bind. */
export function freeReferences(tree: Tree): References {
  const found: References = new Map()
  const add = (name: string, node: Tree) => {
    const nodes = found.get(name)
    if (nodes) nodes.push(node)
    else found.set(name, [node])
  }

  function visit(node: Tree, scopes: EnclosingScopes, parent?: Tree) {
    switch (node.type) {
      case 'Identifier':
        if (isProperty(node, parent) || scopes.names.some((names) => names.has(node.name))) return
        if (node.name === 'arguments' && scopes.ownsArguments) return
        recordMember(node, parent)
        return add(node.name, node)
      case 'ThisExpression':
        if (scopes.ownsThis) return
        recordMember(node, parent)
        return add('this', node)
      case 'MetaProperty':
        return node.meta.name === 'new' && !scopes.ownsThis ? add('new.target', node) : undefined
      case 'Super':
        return scopes.privates.has('super') ? undefined : add('super', node)
      case 'PrivateIdentifier':
        return scopes.privates.has(`#${node.name}`) ? undefined : add(`#${node.name}`, node)
    }
    const childScopes = scopesInside(node, scopes, parent)
    for (const child of Object.values(node).flat())
      if (child && typeof child === 'object' && typeof child.type === 'string')
        visit(child as Tree, childScopes, node)
  }

  visit(tree, { names: [], ownsThis: false, ownsArguments: false, privates: new Set() })
  return found
}

/** Records the property that is read from a node, for messages. */
function recordMember(node: Tree, parent?: Tree) {
  if (parent?.type === 'MemberExpression' && !parent.computed && parent.object === node)
    node.member = parent.property.name
}

/** Returns the scopes that enclose the children of a node. */
function scopesInside(node: Tree, scopes: EnclosingScopes, parent?: Tree): EnclosingScopes {
  const names = namesOf(node)
  const here = names.length ? [...scopes.names, new Set(names)] : scopes.names
  if (/Function/.test(node.type) && node.type !== 'ArrowFunctionExpression')
    return { ...scopes, names: here, ownsThis: true, ownsArguments: true }
  if (
    node.type === 'StaticBlock' ||
    (parent?.type === 'PropertyDefinition' && parent.value === node)
  )
    return { ...scopes, names: here, ownsThis: true }
  if (node.type !== 'ClassBody') return { ...scopes, names: here }
  const keys = node.body
    .filter(({ key }: Tree) => key?.type === 'PrivateIdentifier')
    .map(({ key }: Tree) => `#${key.name}`)
  return { ...scopes, names: here, privates: new Set([...scopes.privates, ...keys, 'super']) }
}

/** Returns the names that a node binds for its children. */
function namesOf(node: Tree): string[] {
  if (/^Class(Declaration|Expression)$/.test(node.type)) return namesBoundBy(node.id)
  return scopeOf(node)
}

/** A place in a script. */
export interface Place {
  text: string
  program: Tree
  isModule: boolean
  start: number
  end: number
}

/** Returns the names that are bound around a place, except those at the top of a classic script, which are global. */
export function namesAround({ program, isModule, start, end }: Place): Set<string> {
  const names = new Set<string>()
  const visit = (node: Tree) => {
    if (node.start > start || node.end < end) return
    // Names that the function itself binds are not around it.
    if (node.start === start && node.end === end && /Function|Class/.test(node.type)) return
    if (node.type !== 'Program' || isModule) for (const name of namesOf(node)) names.add(name)
    if (/Function/.test(node.type) && node.type !== 'ArrowFunctionExpression')
      names.add('arguments')
    for (const child of Object.values(node).flat())
      if (child && typeof child === 'object' && typeof child.type === 'string') visit(child as Tree)
  }
  visit(program)
  return names
}
