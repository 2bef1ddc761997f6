// What is told on the way, on stderr, so that stdout has only the result.
import { printable } from './printable.js'

export const count = (number: number, one: string, many = `${one}s`) =>
  `${number.toLocaleString('en-US')} ${number === 1 ? one : many}`

export class Progress {
  private shown = -Infinity
  private isOpen = false

  constructor(private readonly isQuiet: boolean) {}

  /** A line that stays. */
  step(text: string) {
    if (this.isQuiet) return
    this.clear()
    process.stderr.write(`${printable(text)}\n`)
  }

  /** Takes away a line that `update` wrote. */
  clear() {
    if (this.isOpen) process.stderr.write('\r\x1b[K')
    this.isOpen = false
  }

  /** A line that the next one replaces, at most ten times a second; only where somebody watches. */
  update(text: string) {
    if (this.isQuiet || !process.stderr.isTTY || performance.now() < this.shown + 100) return
    this.shown = performance.now()
    this.isOpen = true
    process.stderr.write(`\r\x1b[K${text}`)
  }
}
