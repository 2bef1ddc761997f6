/** Reads, from comments that the frame writes, which lines of the sketch each statement of shader code was generated from. */

const originComment = /^\s*\/\/ From line (\d+)$/

/** Splits code with such comments into lines. Returns [{ text, from }], where `from` lists line numbers of the sketch. */
export function withOrigins(code) {
  const lines = []
  let from = []
  for (const text of code.split('\n')) {
    const [, line] = originComment.exec(text) ?? []
    if (line) {
      if (!from.includes(Number(line))) from.push(Number(line))
      continue
    }
    lines.push({ text, from })
    from = []
  }
  return lines
}

/** Removes these comments from code. */
export const removeOrigins = (code) =>
  withOrigins(code)
    .map(({ text }) => text)
    .join('\n')
