// Finds the line of the user's code that called the library.

/** Returns the lines of a stack that have a line number. */
export function stackLines(error = new Error()): string[] {
  return (error.stack ?? '').split('\n').filter((line) => /:\d+:\d+\)?$/.test(line))
}

/**
 * Returns the address of the file in a line of a stack. The pattern allows for function names that end in "at", such as `format` or a
 * minified name.
 */
export const fileOf = (line: string) =>
  line.replace(/:\d+:\d+\)?$/, '').replace(/^.*?(\(|@|at (?!\())(?=\S*$)/, '')

/** Returns the name of the file in a line of a stack, without its folder. */
export const fileNameOf = (line: string) =>
  fileOf(line)
    .replace(/[?#].*$/, '')
    .replace(/^.*\//, '') || 'the page'

/**
 * The common prefix of the addresses of the library's files: this file's address, or the folder of the files that entries share. Found
 * when it is first needed.
 */
let libraryPrefix: string | undefined

/** Returns the first line of the stack that is outside of the library's files, such as `From setup (sketch.js:12:5)`. */
export function callerLine(): string {
  const lines = stackLines()
  libraryPrefix ??= fileOf(lines[0] ?? '').replace(/(?<=[/\\]shared[/\\])[\w-]+\.js$/, '')
  const line = lines.find((line) => !fileOf(line).startsWith(libraryPrefix!)) ?? 'an unknown line'
  return (
    'From ' +
    line
      .trim()
      .replace(/^at /, '')
      .replace(/[\r\n]/g, ' ')
  )
}
