// Functions of a script by their names, as scopes bind them.
import type { Place } from './resolve.js'
import { scopeOf, walk } from './scopes.js'
import type { Tree } from './tree.js'

/** The nodes around a place, from the program inwards. */
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

/** The innermost node around a place that binds a name. */
export const binderOf = (path: Tree[], name: string) =>
  [...path].reverse().find((node) => scopeOf(node).includes(name))

/** The function that a scope binds under a name, if that is never set again. */
export function definitionIn(scope: Tree, name: string): Tree | undefined {
  const found: Tree[] = []
  walk(scope, (node) => {
    if (node.type === 'FunctionDeclaration' && node.id?.name === name) found.push(node)
    if (node.type === 'VariableDeclarator' && node.id.name === name) found.push(node.init ?? node)
  })
  const [definition, ...others] = found
  const isFunction = !!definition && /Function/.test(definition.type)
  return isFunction && !others.length && !isSet(scope, name) ? definition : undefined
}

function isSet(scope: Tree, name: string): boolean {
  let found = false
  walk(scope, ({ type, left, argument }) => {
    if (type === 'AssignmentExpression' && left.name === name) found = true
    if (type === 'UpdateExpression' && argument.name === name) found = true
  })
  return found
}
