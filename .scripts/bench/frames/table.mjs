// Formats tables of figures for the terminal.
import { paint } from '../../lib/terminal.mjs'

/** Formats a number with `digits` decimals. */
export const withDecimals = (digits) => (value) => value.toFixed(digits)

/** Returns a formatter with as many decimals as the largest of `values` needs for three digits, so that numbers compare at a glance. */
export function sameDecimals(values) {
  const largest = Math.max(...values.filter(Number.isFinite).map(Math.abs))
  return withDecimals(largest >= 100 ? 0 : largest >= 10 ? 1 : 2)
}

/**
 * @param columns [{ head: [upper, lower], text, left? }]: `text(record)` returns a cell, or `undefined` if it is empty. Cells are aligned
 * to the right, or to the left with `left`
 * @param style `style(record, column)` returns the style of a cell, or `undefined`
 * @returns two header lines and one line for each record
 */
export function table(columns, records, style = () => undefined) {
  const padded = columns.map(({ head, text, left }) => {
    const cells = [...head, ...records.map((record) => text(record) ?? '–')]
    const width = Math.max(...cells.map(({ length }) => length))
    return cells.map((cell) => (left ? cell.padEnd(width) : cell.padStart(width)))
  })
  const styleOf = (line, column) => (line < 2 ? 'dim' : style(records[line - 2], column))
  return padded[0].map((_, line) => {
    const cells = columns.map((column, i) => {
      const name = styleOf(line, column)
      const text = i === columns.length - 1 ? padded[i][line].trimEnd() : padded[i][line]
      return name ? paint(name, text) : text
    })
    return cells.join('  ').trimEnd()
  })
}
