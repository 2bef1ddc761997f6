// Writes the generated parts of pages that are otherwise written by hand. A part is between `<!-- name -->` and `<!-- end of name -->`.
import { readFileSync } from 'node:fs'
import { path } from '../lib/files.mjs'
import { Stop } from '../lib/terminal.mjs'

/** Replaces the generated parts of a page and formats it; returns the new text. `parts` maps the name of a part → its Markdown. */
export async function replaceParts(file, parts) {
  let text = readFileSync(path(file), 'utf8')
  for (const [name, part] of Object.entries(parts)) {
    const pattern = RegExp(`(<!-- ${name} -->\\n)[^]*?(<!-- end of ${name} -->)`)
    if (!pattern.test(text))
      throw new Stop(`${file} lacks <!-- ${name} --> … <!-- end of ${name} -->.`)
    text = text.replace(pattern, (_, start, end) => `${start}\n${part}\n\n${end}`)
  }
  return formatAs(file, text)
}

/** Formats text with Prettier, as the content of `file`. */
export async function formatAs(file, text) {
  const { format, resolveConfig } = await import('prettier')
  return format(text, { ...(await resolveConfig(path(file))), filepath: path(file) })
}

/** Returns Markdown for code in a line. */
export const code = (text) => `\`${text}\``

/** Ends a description with a full stop, unless it ends with a full stop or an exclamation mark. */
export const endSentence = (text) => (/[.!]$/.test(text) ? text : `${text}.`)

/** Returns rows of cells as a Markdown table. The columns after the first are aligned to the right if `isNumeric`. */
export const markdownTable = (head, rows, isNumeric = false) =>
  [head, head.map((_, i) => (isNumeric && i ? '--:' : '---')), ...rows]
    .map((cells) => `| ${cells.map((cell) => String(cell).replaceAll('|', '\\|')).join(' | ')} |`)
    .join('\n')
