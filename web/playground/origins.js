/** Which lines of the sketch each statement of a text is from, as comments of the frame say it. */

const told = /^\s*\/\/ From line (\d+)$/

/** A text with such comments → [{ text, from }], a line each; `from` are lines of the sketch. */
export function withOrigins(code) {
  const lines = []
  let from = []
  for (const text of code.split('\n')) {
    const [, line] = told.exec(text) ?? []
    if (line) {
      if (!from.includes(Number(line))) from.push(Number(line))
      continue
    }
    lines.push({ text, from })
    from = []
  }
  return lines
}

/** The text without them. */
export const plain = (code) =>
  withOrigins(code)
    .map(({ text }) => text)
    .join('\n')
