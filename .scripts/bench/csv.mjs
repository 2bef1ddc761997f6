// A CSV file (RFC 4180) that grows by the lines of each run.
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { Stop } from '../lib/terminal.mjs'

const field = (value) => {
  const text = String(value ?? '')
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** One line, without its end. What is undefined or null is an empty field. */
export const csvLine = (fields) => fields.map(field).join(',')

const contentOf = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : '')

/** Throws where nothing can be appended to `file`. */
function checkWritable(file) {
  try {
    mkdirSync(dirname(file), { recursive: true })
    appendFileSync(file, '')
  } catch {
    throw new Stop(`${file} cannot be written: name another file with --out.`)
  }
}

/** Throws where `file` is another table or cannot be written: better before a long measurement than after it. */
export function checkColumns(file, columns) {
  checkWritable(file)
  const [header] = contentOf(file).split(/\r?\n/, 1)
  if (header && header !== csvLine(columns))
    throw new Stop(`${file} has other columns than the benchmark: name another file with --out.`)
}

/** Appends lines, each an array of fields, below the header, which a new file gets first. */
export function appendLines(file, columns, lines) {
  mkdirSync(dirname(file), { recursive: true })
  const kept = contentOf(file)
  const all = (kept ? lines : [columns, ...lines]).map(csvLine)
  const lineEnd = kept && !kept.endsWith('\n') ? '\n' : ''
  appendFileSync(file, `${lineEnd}${all.join('\n')}\n`)
}
