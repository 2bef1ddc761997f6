import type { Node } from 'acorn'

/** Of any kind: acorn's own types name each apart. */
export type Tree = Node & Record<string, any>

/** The nodes in a node, in the order of the text. Of `{ amount = 2 }`, name and pattern are one. */
export const childrenOf = (node: Tree): Tree[] =>
  Object.entries(node)
    .filter(([name]) => !(node.shorthand && name === 'key'))
    .flatMap(([, value]) => value as unknown)
    .filter(
      (value): value is Tree =>
        !!value && typeof value === 'object' && typeof (value as Tree).type === 'string',
    )
    .filter(
      (value, i, all) =>
        all.findIndex((other) => other.start === value.start && other.end === value.end) === i,
    )
    .sort((a, b) => a.start - b.start)
