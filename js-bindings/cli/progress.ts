// Prints progress on stderr, so that stdout has only the result.
import { printable } from './printable.js'

/** Writes a number with its noun, such as `1,200 vertices`. */
export const count = (number: number, singular: string, plural = `${singular}s`) =>
  `${number.toLocaleString('en-US')} ${number === 1 ? singular : plural}`

export class Progress {
  private lastUpdate = -Infinity
  private hasTemporaryLine = false

  constructor(private readonly isQuiet: boolean) {}

  /** Prints a line that stays. */
  step(text: string) {
    if (this.isQuiet) return
    this.clear()
    process.stderr.write(`${printable(text)}\n`)
  }

  /** Removes the temporary line that `update` has printed, if there is one. */
  clear() {
    if (this.hasTemporaryLine) process.stderr.write('\r\x1b[K')
    this.hasTemporaryLine = false
  }

  /** Prints a temporary line, which the next output replaces. Prints at most 10 such lines per second, and only if stderr is a terminal. */
  update(text: string) {
    if (this.isQuiet || !process.stderr.isTTY || performance.now() < this.lastUpdate + 100) return
    this.lastUpdate = performance.now()
    this.hasTemporaryLine = true
    process.stderr.write(`\r\x1b[K${text}`)
  }
}
