// Prints progress on stderr, so that stdout has only the result.
import { printable } from './printable.js'

export const count = (number: number, one: string, many = `${one}s`) =>
  `${number.toLocaleString('en-US')} ${number === 1 ? one : many}`

export class Progress {
  private shown = -Infinity
  private isOpen = false

  constructor(private readonly isQuiet: boolean) {}

  /** Prints a line that stays. */
  step(text: string) {
    if (this.isQuiet) return
    this.clear()
    process.stderr.write(`${printable(text)}\n`)
  }

  /** Removes a line that `update` printed. */
  clear() {
    if (this.isOpen) process.stderr.write('\r\x1b[K')
    this.isOpen = false
  }

  /** Prints a line that the next one replaces, at most 10 times per second, if stderr is a terminal. */
  update(text: string) {
    if (this.isQuiet || !process.stderr.isTTY || performance.now() < this.shown + 100) return
    this.shown = performance.now()
    this.isOpen = true
    process.stderr.write(`\r\x1b[K${text}`)
  }
}
