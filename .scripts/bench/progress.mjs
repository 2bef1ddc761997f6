// What is going on meanwhile: on a terminal one line that is rewritten, elsewhere a line for each stage, so that logs stay short.

/** @param stream where to: stderr by default, so that a file that stdout goes to has the tables alone */
export function openProgress(stream = process.stderr) {
  const start = performance.now()
  let stage = ''
  let isShown = false

  function write(text) {
    stream.write(`\r\x1b[2K${text.slice(0, (stream.columns ?? 80) - 1)}`)
    isShown = Boolean(text)
  }

  function clock() {
    const seconds = Math.floor((performance.now() - start) / 1000)
    return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`
  }

  return {
    begin(name) {
      stage = name
      if (stream.isTTY) write(`${clock()}  ${stage}`)
      else stream.write(`${clock()}  ${stage}\n`)
    },

    /** How far the stage is: on terminals alone. */
    detail(text) {
      if (stream.isTTY) write(`${clock()}  ${stage}, ${text}`)
    },

    /** Makes room for other lines. */
    clear() {
      if (isShown) write('')
    },
  }
}
