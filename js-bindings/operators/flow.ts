// Questions about statements: how they end, what they wait for, and what they change.
import { walk } from './scopes.js'
import type { Tree } from './tree.js'

/** The names of functions that are declared in it for good, and so are translated with it. */
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

/** Methods of p5.Vector that change it. */
const changing = /^(add|sub|mult|div|rem|normalize|setMag|limit|rotate|lerp|reflect)$/

export const changesVector = ({ callee }: Tree): boolean =>
  callee.type === 'MemberExpression' &&
  callee.object.type === 'Identifier' &&
  changing.test(callee.property.name)

/** Returns whether `yield` or `await` is in one of the nodes, which cannot be moved into a function of its own. */
export function isSuspended(nodes: Tree[]): boolean {
  let found = false
  for (const each of nodes)
    walk(each, (node) => {
      if (/^(Yield|Await)Expression$/.test(node.type)) found = true
      return !/Function/.test(node.type)
    })
  return found
}

/** Whether reading it twice is reading it once. */
export const isSteady = (node: Tree): boolean =>
  node.type === 'MemberExpression'
    ? isSteady(node.object) && (!node.computed || isSteady(node.property))
    : /^(Identifier|Literal|ThisExpression|Super)$/.test(node.type)

/** Whether a statement such as `return` is in it, but not in a function of its own. */
export function leaves(node: Tree, type: string): boolean {
  let found = false
  const inLoops = new Set<Tree>()
  const isInLoop = (each: Tree) => inLoops.has(each)
  walk(node, (each) => {
    // A jump of a loop that is itself in the statement stays within it.
    if (/^(For|While|DoWhile)/.test(each.type) && type !== 'ReturnStatement' && each !== node)
      walk(each, (inner) => {
        inLoops.add(inner)
      })
    if (each.type === type && (!isInLoop(each) || each.label)) found = true
    return !/Function/.test(each.type)
  })
  return found
}

/** Whether nothing comes after a block, within a loop neither. */
export const endsFunction = (block: Tree): boolean =>
  endsInReturn(block) && !leaves(block, 'BreakStatement') && !leaves(block, 'ContinueStatement')

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
