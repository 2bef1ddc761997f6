// Appends the lines of each run to a CSV file (RFC 4180).
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { Stop } from '../lib/terminal.mjs'

const field = (value) => {
  const text = String(value ?? '')
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** Returns one line, without a line break. Undefined and null become empty fields. */
export const csvLine = (fields) => fields.map(field).join(',')

const contentOf = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : '')

/** Throws if nothing can be appended to `file`. */
function checkWritable(file) {
  try {
    mkdirSync(dirname(file), { recursive: true })
    appendFileSync(file, '')
  } catch {
    throw new Stop(`${file} cannot be written: name another file with --out.`)
  }
}

/** Throws if `file` has other columns or cannot be written: called first, so that no long measurement is lost. */
export function checkColumns(file, columns) {
  checkWritable(file)
  const [header] = contentOf(file).split(/\r?\n/, 1)
  if (header && header !== csvLine(columns))
    throw new Stop(`${file} has other columns than the benchmark: name another file with --out.`)
}

/** Appends lines, each an array of fields. A new file starts with the header. */
export function appendLines(file, columns, lines) {
  mkdirSync(dirname(file), { recursive: true })
  const before = contentOf(file)
  const all = (before ? lines : [columns, ...lines]).map(csvLine)
  const lineEnd = before && !before.endsWith('\n') ? '\n' : ''
  appendFileSync(file, `${lineEnd}${all.join('\n')}\n`)
}
