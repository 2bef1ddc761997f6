// One compilation: the session in the wasm, which holds all that a sketch built so far. It is closed when the callback
// is over, whatever happened.
import { type Core, type Session, failed, getCore, needsPartials } from './core.js'
import { WarpError, describe } from './errors.js'
import { Expression, toExpression } from './expression.js'
import type { Program } from './evaluate.js'
import type { HostFunction } from './functions.js'
import { isCallable } from './options.js'
import { type Shape, type Variable, imageShape } from './shapes.js'
import { callerOutside } from './source-lines.js'

export const targets = ['glsl300', 'glsl100', 'wgsl'] as const

/** A shading language: GLSL ES 3.00 (WebGL 2), GLSL ES 1.00 (WebGL 1), or WGSL (WebGPU). */
export type Target = (typeof targets)[number]

/** The expression for an image's width and height in texels. */
const sizeOfImage: Record<Target, (image: string) => string> = {
  glsl300: (image) => `vec2(textureSize(${image}, 0))`,
  glsl100: (image) => `${image}Size`,
  wgsl: (image) => `vec2f(textureDimensions(${image}))`,
}

export interface Emitted {
  code: string
  declarations: string
  /** The host's expressions that the text reads. */
  inputs: Variable[]
  outputs: Variable[]
  stats: { nodes: number; operations: number; temporaries: number }
}

/** What `gen` alone has: results that expressions ask for by `.output(name)`, and the lines of the sketch. */
export interface Gen {
  debug: boolean
}

export class Compilation {
  readonly target: Target
  /** The functions of the host, by their number. */
  readonly functions: HostFunction[] = []
  /** Expressions of our own that are read as if they were the host's. */
  private readonly asked = new Set<string>()
  private readonly core: Core = getCore()
  private session: Session | 0
  private readonly gen: Gen | undefined
  /** How many functions' derivatives are being asked for at this moment. */
  private nesting = 0

  constructor(target: unknown, gen?: Gen) {
    if (!targets.includes(target as Target))
      throw new WarpError(
        `The option "target" must be one of ${targets.join(', ')}, but is ${describe(target)}.`,
      )
    this.target = target as Target
    this.session = this.core.open(this.target)
    this.gen = gen
  }

  close() {
    if (this.session && !this.core.isBroken) this.core._closeSession(this.session)
    this.session = 0
  }

  private open(method: string): Session {
    if (!this.session)
      throw new WarpError(
        `${method}: the function that made this expression is over; use expressions only inside it.`,
      )
    if (this.core.isBroken)
      throw new WarpError(
        `${method}: the compiler ran out of memory, and this warp was lost with it; make it again.`,
      )
    return this.session
  }

  private refuse(): never {
    throw new WarpError(this.core.problem(this.open('problem')))
  }

  private expression(handle: number): Expression {
    if (handle === failed) this.refuse()
    if (this.gen?.debug) this.core.comment(this.open('debug'), callerOutside())
    return new Expression(this, handle)
  }

  shapeOf(value: Expression): Shape {
    const shape = this.core._shapeOf(this.open('shape'), value.handle)
    return [shape >> 4, shape & 15]
  }

  /** Whether a value is computed from an input. */
  dependsOn(value: Expression, input: Expression): boolean {
    return !!this.core._dependsOn(this.open('dependsOn'), value.handle, input.handle)
  }

  /** A number that float32 can hold; see `toExpression`. */
  constant(value: number, method: string): Expression {
    return this.expression(this.core._constant(this.open(method), value))
  }

  /** A variable of the host, by the expression that reads it there. */
  input(label: unknown, [columns, rows]: Shape, method: string): Expression {
    const session = this.open(method)
    if (typeof label !== 'string')
      throw new WarpError(
        `${method}: the name of a shader variable was expected, but ${describe(label)} came.`,
      )
    return this.expression(this.core.input(session, method, label, columns, rows))
  }

  /** An operation by its number; a method's first operand is what it is called on. */
  call(operation: number, method: string, operands: readonly Expression[], isMethod = false) {
    const session = this.open(method)
    for (;;) {
      for (const { handle } of operands) this.core._push(session, handle)
      const result = this.core._call(session, operation, isMethod)
      if (result !== needsPartials) return this.expression(result)
      this.givePartials(session)
    }
  }

  swizzle(name: string, value: Expression, indices: readonly number[]): Expression {
    const session = this.open(name)
    const packed = indices.reduce((bits, index, i) => bits | (index << (2 * i)), 0)
    const result = this.core._swizzle(session, value.handle, indices.length, packed)
    if (result === failed) throw new WarpError(`${name}: ${this.core.problem(session)}`)
    return this.expression(result)
  }

  addFunction(hostFunction: HostFunction, source: string): number {
    const { name, arity } = hostFunction
    const number = this.core.addFunction(this.open('fn'), name, source, arity)
    if (number === failed) this.refuse()
    this.functions[number] = hostFunction
    return number
  }

  callFunction(number: number, name: string, operands: readonly Expression[]): Expression {
    const session = this.open(name)
    for (const { handle } of operands) this.core._push(session, handle)
    return this.expression(this.core._callFunction(session, number))
  }

  /** A kind of noise by its number, of a point, a seed and, for fractals, lacunarity and gain. */
  callNoise(
    kind: number,
    base: number,
    octaves: number,
    name: string,
    operands: readonly Expression[],
    isMethod: boolean,
  ): Expression {
    const session = this.open(name)
    for (const { handle } of operands) this.core._push(session, handle)
    return this.expression(this.core._callNoise(session, kind, base, octaves, isMethod))
  }

  /** The host's image of that name at a vec2, with filter and wrap by number. */
  callTexture(image: string, uv: Expression, filter: number, wrap: number): Expression {
    const session = this.open('texture')
    const size = sizeOfImage[this.target](image)
    // WebGL 1 cannot ask an image for its size, so there it is a variable of the host like others.
    if (this.target !== 'glsl100') this.asked.add(size)
    const operands = [
      uv,
      this.input(image, imageShape, 'texture'),
      this.input(size, [1, 2], 'texture'),
    ]
    for (const { handle } of operands) this.core._push(session, handle)
    return this.expression(this.core._callTexture(session, filter, wrap))
  }

  /** A derivative meets calls of the host's functions: the sketch says what their partial derivatives are there. */
  private givePartials(session: Session) {
    const calls = Array.from({ length: this.core._pendingCount(session) }, (_, place) =>
      this.core._pendingCall(session, place),
    )
    for (const call of calls) this.givePartialsOf(session, call)
  }

  private givePartialsOf(session: Session, call: number) {
    const { name, arity, derivatives } = this.functions[this.core._functionOfCall(session, call)]!
    if (!derivatives)
      throw new WarpError(
        `${name}: its derivatives are needed here; give glsl.fn the option "derivatives", one for each argument.`,
      )
    if (this.nesting === 100)
      throw new WarpError(
        `${name}: its derivative needs a derivative of itself; write it with calls of functions instead.`,
      )
    const operands = Array.from(
      { length: arity },
      (_, i) => new Expression(this, this.core._argumentOfCall(session, call, i)),
    )
    const partialOf = (given: unknown, i: number) =>
      toExpression(
        this,
        name,
        isCallable(given) ? given(...(operands as never[])) : given,
        `derivative ${i + 1}`,
      )
    this.nesting++
    let partials: Expression[]
    try {
      partials = Array.from(derivatives, partialOf)
    } finally {
      this.nesting--
    }
    for (const { handle } of partials) this.core._push(session, handle)
    if (!this.core._setPartials(session, call)) this.refuse()
  }

  /** Asks for a result by the method of an expression. */
  ask(name: unknown, value: Expression, method: string) {
    if (!this.gen)
      throw new WarpError(
        `${method}: only gen takes results this way; return the expression from the function instead.`,
      )
    this.output(name, value, method)
  }

  /** Adds a result under a name. */
  output(name: unknown, value: Expression, method: string) {
    const session = this.open(method)
    if (!this.core.output(session, method, resultName(name, method), value.handle)) this.refuse()
  }

  /** A result that is also the sum of an input and the earlier output number `term`, for shorter text. */
  outputSum(name: unknown, value: Expression, input: Expression, term: number, method: string) {
    const session = this.open(method)
    const text = resultName(name, method)
    if (!this.core.outputSum(session, method, text, value.handle, input.handle, term)) this.refuse()
  }

  /** For the CPU; nothing if it would call a function of the host. */
  program(results: readonly Expression[]): Program | undefined {
    const session = this.open('program')
    for (const { handle } of results) this.core._push(session, handle)
    if (!this.core._makeProgram(session)) {
      if (this.core.problem(session)) this.refuse()
      return undefined
    }
    const at = this.core._programWords(session) / 4
    return {
      words: this.core.HEAPU32.slice(at, at + this.core._programSize(session)),
      instructions: this.core._instructionCount(session),
      inputs: readLines(this.core.allInputLines(session)),
    }
  }

  /** A `maxDepth` makes temporaries by depth, and not by how much an expression reads. */
  build(maxDepth = 0): Emitted {
    const session = this.open('build')
    if (!this.core.build(session, Math.min(maxDepth, 2 ** 30))) this.refuse()
    return {
      code: this.core.code(session),
      declarations: this.core.declarations(session),
      inputs: readLines(this.core.inputLines(session)).filter(({ name }) => !this.asked.has(name)),
      outputs: readLines(this.core.outputLines(session)),
      stats: {
        nodes: this.core._nodeCount(session),
        operations: this.core._operationCount(session),
        temporaries: this.core._temporaryCount(session),
      },
    }
  }
}

const readLines = (lines: string): Variable[] =>
  lines
    .split('\n')
    .slice(0, -1)
    .map((line) => ({ name: line.slice(2), shape: [Number(line[0]), Number(line[1])] }))

function resultName(name: unknown, method: string): string {
  if (typeof name === 'string') return name
  throw new WarpError(`${method}: the name of a result must be a text, but is ${describe(name)}.`)
}
