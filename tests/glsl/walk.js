// An interpreter of GLSL in double precision, for tests only: it walks over the tree that an independent parser makes of the whole
// source, and shares no code with our front end. Values carry their types at run time; there is no static analysis.
import { createRequire } from 'node:module'
import { Statements } from './walk/statements.js'
import { newValue, numbersOf } from './walk/values.js'

const require = createRequire(import.meta.url)
const { parser } = require('@shaderfrog/glsl-parser')
const { preprocess } = require('@shaderfrog/glsl-parser/preprocessor')

class Walk extends Statements {
  constructor(program) {
    super(program)
    this.restart()
  }

  /** Initializes globals; each call from outside does so, as a GPU does for each vertex. */
  restart() {
    this.scopes = [new Map()]
    this.functions.length = 0
    for (const node of this.program) {
      if (node.type === 'function') this.functions.push(node)
      else this.statement(node)
    }
  }

  call(name, numbers) {
    this.restart()
    const f = this.functions.find(({ prototype }) => prototype.header.name.identifier === name)
    const operands = f.prototype.parameters.map((parameter, i) =>
      newValue(this.typeOf(parameter), numbers[i], true),
    )
    return numbersOf(this.enter(f, operands))
  }
}

/** Returns a function of the source as a JavaScript function of lists of numbers: `walk(text, 'f')([1, 2, 3])` calls `f` with a vec3. */
export function walk(text, name) {
  const tree = parser.parse(preprocess(text, { preserve: { version: () => true } }), {
    quiet: true,
  })
  const walker = new Walk(tree.program)
  return (...numbers) => walker.call(name, numbers)
}
