// Columns of figures for a terminal.
import { paint } from '../lib/terminal.mjs'

const GAP = '  '
const NONE = '–'

/** With `digits` places after the point. */
export const fixed = (digits) => (value) => value.toFixed(digits)

/** With as many places after the point as show three digits of the largest of `values`, so that all can be compared at a glance. */
export function alike(values) {
  const largest = Math.max(...values.filter(Number.isFinite).map(Math.abs))
  return fixed(largest >= 100 ? 0 : largest >= 10 ? 1 : 2)
}

/**
 * @param columns [{ head: [upper, lower], text, left? }]: `text(record)` is a cell, or undefined where it has none; with `left` it
 * begins where the column does, otherwise it ends where the column ends
 * @param style `style(record, column)` names how a cell is painted, if at all
 * @returns lines: two of head, one for each record
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
