// Finds functions of a script by name, following its scopes.
import type { Place } from './resolve.js'
import { scopeOf, walk } from './scopes.js'
import type { Tree } from './tree.js'

/** Returns the nodes around a place, from the program inwards. */
export function pathTo({ program, start, end }: Omit<Place, 'text' | 'isModule'>): Tree[] {
  const path: Tree[] = []
  walk(program, (node) => {
    if (node.start > start || node.end < end) return false
    if (!(node.start === start && node.end === end && /Function|Class/.test(node.type)))
      path.push(node)
    return true
  })
  return path
}

/** Returns the innermost node of a path that binds a name. */
export const binderOf = (path: Tree[], name: string) =>
  [...path].reverse().find((node) => scopeOf(node).includes(name))

/** Returns the function that a scope binds to a name; `undefined` if the name is assigned again. */
export function definitionIn(scope: Tree, name: string): Tree | undefined {
  const found: Tree[] = []
  walk(scope, (node) => {
    if (node.type === 'FunctionDeclaration' && node.id?.name === name) found.push(node)
    if (node.type === 'VariableDeclarator' && node.id.name === name) found.push(node.init ?? node)
  })
  const [definition, ...others] = found
  const isFunction = !!definition && /Function/.test(definition.type)
  return isFunction && !others.length && !isAssigned(scope, name) ? definition : undefined
}

function isAssigned(scope: Tree, name: string): boolean {
  let found = false
  walk(scope, ({ type, left, argument }) => {
    if (type === 'AssignmentExpression' && left.name === name) found = true
    if (type === 'UpdateExpression' && argument.name === name) found = true
  })
  return found
}
