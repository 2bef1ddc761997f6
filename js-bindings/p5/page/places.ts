/** Adds the file and line of the sketch to the message of a WarpError. */
import { WarpError } from '../../errors/errors.js'
import { fileNameOf, fileOf, stackLines } from '../../errors/source-lines.js'

/** Recognizes p5's own files under the names of common servers. */
const isOfP5 = (file: string) =>
  /\/(?:@?p5(?:@[\w.]+)?\/lib\/)?p5(?:\.\w+)*\.js\b|\/p5@?[^/]*\/lib\//.test(file)

/** The address of this file; if the library is one bundle, the address of the bundle. */
let libraryFile: string | undefined

/** Number of lines that `new Function` puts before a function's body. */
const linesBefore = 3

/** Returns text such as ` (sketch.js, line 12)`; empty if the browser's stack trace lacks the line. */
export function placeOf(error: Error): string {
  libraryFile ??= fileOf(stackLines()[0] ?? '')
  const isOfSketch = (each: string) => {
    const file = fileOf(each)
    return file !== libraryFile && !isOfP5(file) && !/\/dist\/(?:shared\/)?[\w.-]+\.js$/.test(file)
  }
  const lines = stackLines(error)
  const line = lines.find(isOfSketch)
  const [, lineNumber] = /:(\d+):\d+\)?$/.exec(line ?? '') ?? []
  const isTranslated = (each: string) => /warpjet-operators-\d+\.js/.test(each)
  if (lineNumber && isTranslated(line!)) {
    // In a translated function, lines are counted from its start, which we take to be the line where createWarp is called.
    const call = lines
      .slice(lines.indexOf(line!))
      .find((each) => isOfSketch(each) && !isTranslated(each))
    const [, startLine] = /:(\d+):\d+\)?$/.exec(call ?? '') ?? []
    return startLine
      ? ` (${fileNameOf(call!)}, line ${+startLine + +lineNumber - linesBefore})`
      : ''
  }
  return lineNumber ? ` (${fileNameOf(line!)}, line ${lineNumber})` : ''
}

/** V8's limit on stack traces. */
const stacks = Error as { stackTraceLimit?: number }

/** Runs `work`; adds the sketch's line to the message of a `WarpError` that it throws. */
export function withSketchLine<Result>(work: () => Result): Result {
  const { stackTraceLimit } = stacks
  // About ten frames are our own.
  stacks.stackTraceLimit = 50
  try {
    return work()
  } catch (error) {
    if (error instanceof WarpError && !/ \(\S+, line \d+\)$/.test(error.message)) {
      const place = placeOf(error)
      const { message, stack } = error
      if (place) {
        error.message = message + place
        if (stack) error.stack = stack.replace(message, error.message)
      }
    }
    throw error
  } finally {
    stacks.stackTraceLimit = stackTraceLimit
  }
}
