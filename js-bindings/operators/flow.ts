// Checks of statements: whether they return, break, suspend or change vectors.
import { walk } from './scopes.js'
import type { Tree } from './tree.js'

/** Returns the names of functions that the tree declares and never reassigns. They are translated with the tree. */
export function functionNamesIn(tree: Tree): Set<string> {
  const names = new Set<string>()
  walk(tree, (node, parent) => {
    if (node.type === 'FunctionDeclaration') names.add(node.id.name)
    if (
      node.type === 'VariableDeclarator' &&
      parent!.kind === 'const' &&
      /Function/.test(node.init?.type ?? '')
    )
      names.add(node.id.name)
  })
  return names
}

/** Methods of p5.Vector that change the vector. */
const mutatingMethods = /^(add|sub|mult|div|rem|normalize|setMag|limit|rotate|lerp|reflect)$/

export const changesVector = ({ callee }: Tree): boolean =>
  callee.type === 'MemberExpression' &&
  callee.object.type === 'Identifier' &&
  mutatingMethods.test(callee.property.name)

/** Returns whether one of the nodes contains `yield` or `await`. Such nodes cannot be moved into a separate function. */
export function containsSuspension(nodes: Tree[]): boolean {
  let found = false
  for (const each of nodes)
    walk(each, (node) => {
      if (/^(Yield|Await)Expression$/.test(node.type)) found = true
      return !/Function/.test(node.type)
    })
  return found
}

/** Returns whether an expression can be evaluated twice with the same result and without side effects. */
export const canRepeat = (node: Tree): boolean =>
  node.type === 'MemberExpression'
    ? canRepeat(node.object) && (!node.computed || canRepeat(node.property))
    : /^(Identifier|Literal|ThisExpression|Super)$/.test(node.type)

/** Returns whether a node contains a jump of the given type, such as `return`, outside nested functions. */
export function containsJump(node: Tree, type: string): boolean {
  let found = false
  const inLoops = new Set<Tree>()
  const isInLoop = (each: Tree) => inLoops.has(each)
  walk(node, (each) => {
    // A `break` or `continue` of a loop inside the node does not leave the node.
    if (/^(For|While|DoWhile)/.test(each.type) && type !== 'ReturnStatement' && each !== node)
      walk(each, (inner) => {
        inLoops.add(inner)
      })
    if (each.type === type && (!isInLoop(each) || each.label)) found = true
    return !/Function/.test(each.type)
  })
  return found
}

/** Returns whether a block always leaves the function, also from within a loop. */
export const endsFunction = (block: Tree): boolean =>
  endsInReturn(block) &&
  !containsJump(block, 'BreakStatement') &&
  !containsJump(block, 'ContinueStatement')

export function endsInReturn(node: Tree): boolean {
  if (node.type === 'ReturnStatement' || node.type === 'ThrowStatement') return true
  if (node.type === 'BlockStatement') return node.body.length > 0 && endsInReturn(node.body.at(-1))
  return (
    node.type === 'IfStatement' &&
    !!node.alternate &&
    endsInReturn(node.consequent) &&
    endsInReturn(node.alternate)
  )
}
