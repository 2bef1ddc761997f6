// Edits source code without changing its lines, and tracks the origin of each piece for a source map.
import type MagicString from 'magic-string'
import type { Tree } from './tree.js'

/** Edit children before their parent, so that text inserted around the parent encloses text inserted around its children. */
export class Edits {
  constructor(
    private readonly text: MagicString,
    readonly source: string,
  ) {}

  /** Inserts text around a node. */
  wrap({ start, end }: Tree, before: string, after: string) {
    this.text.prependRight(start, before)
    this.text.appendLeft(end, after)
  }

  /** Inserts text at a place, after what was inserted there before. */
  append(at: number, text: string) {
    this.text.appendLeft(at, text)
  }

  /** Replaces text that contains no child, and keeps its number of lines. */
  replace(from: number, to: number, text: string) {
    const lines = '\n'.repeat(this.source.slice(from, to).split('\n').length - 1)
    this.text.overwrite(from, to, text + lines, { contentOnly: true })
  }

  /** Replaces the beginning of a node, up to its first child. */
  open({ start }: Tree, to: number, text: string) {
    if (start < to) this.replace(start, to, text)
    else this.text.prependRight(start, text)
  }

  /** Replaces the end of a node, after its last child. */
  close({ end }: Tree, from: number, text: string) {
    if (from < end) this.replace(from, end, text)
    else this.text.appendLeft(end, text)
  }
}
