// Changes of a source text that keep its lines, and know for a source map where each piece is from.
import type MagicString from 'magic-string'
import type { Tree } from './tree.js'

/** The nodes in a node are changed before it, so that what is put around it lies outside of what is put around them. */
export class Edits {
  constructor(
    private readonly text: MagicString,
    readonly source: string,
  ) {}

  /** Puts text around a node. */
  wrap({ start, end }: Tree, before: string, after: string) {
    this.text.prependRight(start, before)
    this.text.appendLeft(end, after)
  }

  /** Puts text at the end of what comes before a place. */
  append(at: number, text: string) {
    this.text.appendLeft(at, text)
  }

  /** Replaces what is between two places, where no node is; its lines stay. */
  replace(from: number, to: number, text: string) {
    const lines = '\n'.repeat(this.source.slice(from, to).split('\n').length - 1)
    this.text.overwrite(from, to, text + lines, { contentOnly: true })
  }

  /** Replaces the beginning of a node, up to what is first in it. */
  open({ start }: Tree, to: number, text: string) {
    if (start < to) this.replace(start, to, text)
    else this.text.prependRight(start, text)
  }

  /** Replaces the end of a node, from what is last in it. */
  close({ end }: Tree, from: number, text: string) {
    if (from < end) this.replace(from, end, text)
    else this.text.appendLeft(end, text)
  }
}
