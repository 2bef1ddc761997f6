import type { Node } from 'acorn'

/** Of any kind: acorn's own types name each apart. */
export type Tree = Node & Record<string, any>
