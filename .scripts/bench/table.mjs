// Formats tables of figures for the terminal.
import { paint } from '../lib/terminal.mjs'

const GAP = '  '
const NONE = '–'

/** Formats a number with `digits` decimals. */
export const withDecimals = (digits) => (value) => value.toFixed(digits)

/** Returns a formatter with as many decimals as the largest of `values` needs for three digits, so that numbers compare at a glance. */
export function alike(values) {
  const largest = Math.max(...values.filter(Number.isFinite).map(Math.abs))
  return withDecimals(largest >= 100 ? 0 : largest >= 10 ? 1 : 2)
}

/**
 * @param columns [{ head: [upper, lower], text, left? }]: `text(record)` returns a cell, or `undefined` if it is empty. Cells are aligned
 * to the right, or to the left with `left`
 * @param style `style(record, column)` returns the style of a cell, or `undefined`
 * @returns two lines of head and one for each record
 */
export function table(columns, records, style = () => undefined) {
  const cells = columns.map(({ text }) => records.map((record) => text(record) ?? NONE))
  const widths = columns.map(({ head }, i) =>
    Math.max(...[...head, ...cells[i]].map(({ length }) => length)),
  )
  const pad = (text, i) => (columns[i].left ? text.padEnd(widths[i]) : text.padStart(widths[i]))
  const heads = [0, 1].map((line) => columns.map(({ head }, i) => pad(head[line], i)).join(GAP))
  const lines = records.map((record, line) =>
    columns.map((column, i) => {
      const name = style(record, column)
      const text = pad(cells[i][line], i)
      return name ? paint(name, text) : text
    }),
  )
  return [
    ...heads.map((text) => paint('dim', text.trimEnd())),
    ...lines.map((cells) => cells.join(GAP).trimEnd()),
  ]
}
