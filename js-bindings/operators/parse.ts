// Parses the source code of one function.
import { parse } from 'acorn'
import type { Tree } from './tree.js'

export interface Parsed {
  /** The source code that positions in the tree refer to. */
  source: string
  tree: Tree
  /** Start and length of the function's own code in the source. */
  start: number
  length: number
}

/**
 * The forms of a function's source code: a function or class, a method of an object, a method of a class. Each becomes a program between
 * `before` and `after`.
 */
const forms: readonly (readonly [before: string, after: string, find: (tree: Tree) => Tree])[] = [
  ['(', '\n)', (tree) => tree.body[0].expression],
  ['({ ', '\n})', (tree) => tree.body[0].expression.properties[0]],
  ['(class { ', '\n})', (tree) => tree.body[0].expression.body.body[0]],
  // An arrow function may use new.target of the enclosing function.
  ['(function () { return ', '\n})', (tree) => tree.body[0].expression.body.body[0].argument],
]

/** Parses a function; returns `undefined` for native code, an `async` function, a generator or a getter. */
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
      // Not this form; try the next.
    }
  }
  return undefined
}
