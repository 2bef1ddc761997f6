import type { Node } from 'acorn'

/** A syntax node of any kind; acorn's own types distinguish the kinds. */
export type Tree = Node & Record<string, any>

/** Returns the children of a node in source order. In `{ amount = 2 }`, the name and the pattern are one child. */
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
