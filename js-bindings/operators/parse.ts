// The text of one function as a tree.
import { parse } from 'acorn'
import type { Tree } from './tree.js'

export interface Parsed {
  /** The text that positions in the tree refer to. */
  source: string
  tree: Tree
  /** The function's own text begins there in the source, and has that length. */
  start: number
  length: number
}

/** The kinds of text that a function can have: a function, a class, or a method of an object or a class. */
const forms: readonly (readonly [before: string, after: string, find: (tree: Tree) => Tree])[] = [
  ['(', '\n)', (tree) => tree.body[0].expression],
  ['({ ', '\n})', (tree) => tree.body[0].expression.properties[0]],
  ['(class { ', '\n})', (tree) => tree.body[0].expression.body.body[0]],
  // An arrow function may use new.target of what is around it.
  ['(function () { return ', '\n})', (tree) => tree.body[0].expression.body.body[0].argument],
]

/** The function, or nothing for native code, an `async` function, a generator or a getter. */
export function parseFunction(f: Function): Parsed | undefined {
  const text = Function.prototype.toString.call(f)
  for (const [before, after, find] of forms) {
    const source = before + text + after
    try {
      const program = parse(source, {
        ecmaVersion: 'latest',
        allowSuperOutsideMethod: true,
        checkPrivateFields: false,
      } as never)
      const found = find(program as Tree)
      if (/^(get|set)$/.test(found.kind)) return undefined
      const tree: Tree = found.value ?? found
      if (!/Function|Class/.test(tree.type) || tree.async || tree.generator) continue
      return { source, tree, start: before.length, length: text.length }
    } catch {
      // Another form.
    }
  }
  return undefined
}
