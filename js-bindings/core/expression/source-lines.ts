// Where in the user's code an operation was written.

/** Of a stack, those that name a place. */
export function stackLines(error = new Error()): string[] {
  return (error.stack ?? '').split('\n').filter((line) => /:\d+:\d+\)?$/.test(line))
}

/** The name before the bracket may itself end in "at", as `format` does, and as a minifier may name any function. */
export const fileOf = (line: string) =>
  line.replace(/:\d+:\d+\)?$/, '').replace(/^.*?(\(|@|at (?!\())(?=\S*$)/, '')

/** The file's name alone. */
export const nameIn = (line: string) =>
  fileOf(line)
    .replace(/[?#].*$/, '')
    .replace(/^.*\//, '') || 'the page'

/** The prefix that the addresses of our files share: this file's address, or the folder of the files that entries share. Found on
 * first use. */
let ours: string | undefined

/** The first line of the stack that is not ours, such as `setup (sketch.js:12:5)`. */
export function callerOutside(): string {
  const lines = stackLines()
  ours ??= fileOf(lines[0] ?? '').replace(/(?<=[/\\]shared[/\\])[\w-]+\.js$/, '')
  const line = lines.find((line) => !fileOf(line).startsWith(ours!)) ?? 'an unknown line'
  return (
    'From ' +
    line
      .trim()
      .replace(/^at /, '')
      .replace(/[\r\n]/g, ' ')
  )
}
