/** Where in the sketch a WarpError comes from, added to its sentence. */
import { WarpError } from '../../errors/errors.js'
import { fileOf, nameIn, stackLines } from '../../core/expression/source-lines.js'

/** p5's own files, by whatever name they are served. */
const isOfP5 = (file: string) =>
  /\/(?:@?p5(?:@[\w.]+)?\/lib\/)?p5(?:\.\w+)*\.js\b|\/p5@?[^/]*\/lib\//.test(file)

let ours: string | undefined

/** Of a function that `new Function` makes. */
const linesBefore = 3

/** Such as ` (sketch.js, line 12)`; nothing where the browser does not tell. */
export function placeOf(error: Error): string {
  ours ??= fileOf(stackLines()[0] ?? '')
  const isSketch = (each: string) => {
    const file = fileOf(each)
    return file !== ours && !isOfP5(file) && !/\/dist\/(?:shared\/)?[\w.-]+\.js$/.test(file)
  }
  const lines = stackLines(error)
  const line = lines.find(isSketch)
  const [, number] = /:(\d+):\d+\)?$/.exec(line ?? '') ?? []
  const isRemade = (each: string) => /warpjet-operators-\d+\.js/.test(each)
  if (number && isRemade(line!)) {
    // Counted from the beginning of the function, which stands where createWarp is called.
    const call = lines.slice(lines.indexOf(line!)).find((each) => isSketch(each) && !isRemade(each))
    const [, first] = /:(\d+):\d+\)?$/.exec(call ?? '') ?? []
    return first ? ` (${nameIn(call!)}, line ${+first + +number - linesBefore})` : ''
  }
  return number ? ` (${nameIn(line!)}, line ${number})` : ''
}

/** As V8 has it. */
const stacks = Error as { stackTraceLimit?: number }

/** Does some work of ours for a sketch. */
export function located<Result>(work: () => Result): Result {
  const { stackTraceLimit } = stacks
  // Some ten places are our own.
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
