// Where in the user's code an operation was written, for `debug` comments.

function stackLines(): string[] {
  return (new Error().stack ?? '').split('\n').filter((line) => /:\d+:\d+\)?$/.test(line))
}

const fileOf = (line: string) =>
  line.replace(/:\d+:\d+\)?$/, '').replace(/^.*?(\(|@|at )(?=\S*$)/, '')

/** The file that this code is in, a bundle or this one, found when it is first needed. */
let ownFile: string | undefined

/** The first line of the stack that is not ours, such as `setup (sketch.js:12:5)`. */
export function callerOutside(): string {
  const lines = stackLines()
  ownFile ??= fileOf(lines[0] ?? '')
  const line = lines.find((line) => fileOf(line) !== ownFile) ?? 'an unknown line'
  return (
    'From ' +
    line
      .trim()
      .replace(/^at /, '')
      .replace(/[\r\n]/g, ' ')
  )
}
