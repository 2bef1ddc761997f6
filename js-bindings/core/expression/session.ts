// One run of a sketch's function: the session in the wasm, which holds all that the sketch built so far. It is closed when
// the callback is over, whatever happened.
import { type Core, type SessionHandle, getCore, laid } from '../../wasm/core.js'
import { WarpError, describe } from '../../errors/errors.js'
import { Expression, toExpression } from './expression.js'
import type { KeptModule, Target } from '../module/kept-module.js'
import { describeShape } from '../../errors/describe.js'
import { isCallable } from '../../options/options.js'
import type { ReadAsFloats, Shape } from './shapes.js'
import { noteIdle, noteUnused } from './idle.js'
import { callerOutside } from './source-lines.js'
import type { HostSampling } from './sampling.js'
import { failed, needsPartials } from '../../wasm/tables.js'

/** A function of the host from numbers to a number, as the sketch declared it. */
export interface HostFunction {
  name: string
  arity: number
  /** One for each argument: a number, an expression, or a function from the arguments to one of them. */
  derivatives: readonly unknown[] | undefined
}

/** A function of shader text, recorded by itself: numbers go in and come out. */
export interface Recorded {
  name: string
  /** How many of its arguments, the first ones, it has derivatives by. */
  variables: number
  results: number
  module: KeptModule
}

/** How a run is recorded. */
export interface Recording {
  /** Whether expressions ask for results by `.output(name)`, as `gen` alone has it. */
  asks?: boolean
  /** Whether statements say which lines of the sketch they are from. */
  debug?: boolean
}

export class Session {
  /** The inputs that are no floats of the host, by their number. */
  private readonly others = new Map<number, ReadAsFloats>()
  /** Maps the shader's name of an image → the sampling that its host passes. */
  readonly samplings = new Map<string, HostSampling>()
  /** Maps the shader's name of an input of a warp → the input that it is. */
  readonly inputNames = new Map<string, string>()
  /** The functions of the host, by their number. */
  readonly functions: HostFunction[] = []
  private readonly core: Core = getCore()
  private readonly recorded = new Map<Recorded, number>()
  private id: SessionHandle | 0
  /** Maps the handle of an unused expression to its note for the console. */
  private readonly idle = new Map<number, () => void>()
  /** Results of `copy()`, and of methods called on them. */
  private copies: WeakSet<Expression> | undefined
  /** The handles of conditions. */
  private readonly conditions = new Set<number>()
  /** How many functions' derivatives are being asked for at this moment. */
  private nesting = 0

  constructor(
    /** The language of texts of the sketch that do not say theirs. */
    readonly target: Target,
    private readonly recording: Recording = {},
  ) {
    this.id = this.core._openSession()
  }

  close() {
    if (this.id && !this.core.isBroken) this.core._closeSession(this.id)
    this.id = 0
  }

  private open(method: string): SessionHandle {
    if (!this.id)
      throw new WarpError(
        `${method}: the function that made this expression is over; use expressions only inside it.`,
      )
    if (this.core.isBroken)
      throw new WarpError(
        `${method}: the compiler ran out of memory, and this warp was lost with it; make it again.`,
      )
    return this.id
  }

  private refuse(): never {
    throw new WarpError(this.core.problem(this.open('problem')))
  }

  private expression(handle: number): Expression {
    if (handle === failed) this.refuse()
    if (this.recording.debug) this.core.comment(this.open('debug'), callerOutside())
    return new Expression(this, handle)
  }

  shapeOf(value: Expression): Shape {
    const shape = this.core._shapeOf(this.open('shape'), value.handle)
    return [shape >> 4, shape & 15]
  }

  /** The number of an input in the module. */
  numberOf(input: Expression): number {
    return this.core._inputOf(this.open('number'), input.handle)
  }

  /** A number that float32 can hold; see `toExpression`. */
  constant(value: number, method: string): Expression {
    return this.expression(this.core._constant(this.open(method), value))
  }

  /** A variable of the host, by the expression that reads it there. */
  input(label: unknown, [columns, rows]: Shape, method: string): Expression {
    const id = this.open(method)
    if (typeof label !== 'string')
      throw new WarpError(
        `${method}: the name of a shader variable was expected, but ${describe(label)} came.`,
      )
    return this.expression(this.core.input(id, method, label, columns, rows))
  }

  /** A variable of the host that has another type than floats. */
  inputOf(read: ReadAsFloats, shape: Shape, method: string): Expression {
    const input = this.input(read.texts[this.target], shape, method)
    this.others.set(this.numberOf(input), read)
    return input
  }

  private push(id: SessionHandle, operands: readonly Expression[]) {
    for (const operand of operands) {
      this.core._push(id, operand.handle)
      this.use(operand)
    }
  }

  /** Says that something is made of it. */
  use({ handle }: Expression) {
    this.idle.delete(handle)
  }

  /** Returns whether a value is a condition: the result of a comparison, or of logic. */
  isCondition({ handle }: Expression): boolean {
    return this.conditions.has(handle)
  }

  /** Copies the handle, so that a later call on the copy whose result is unused can be noted, as for a p5.Vector. */
  copyOf({ handle }: Expression): Expression {
    const copy = new Expression(this, handle)
    this.copies ??= new WeakSet()
    this.copies.add(copy)
    return copy
  }

  /** To be called with what a method gave: of a copy it is noted if nothing is made of it. */
  followCopy(copy: Expression, method: string, result: unknown) {
    if (!this.copies?.has(copy) || !(result instanceof Expression)) return
    this.copies.add(result)
    if (result.handle === copy.handle) return
    const error = new Error()
    this.idle.set(result.handle, () => noteUnused(method, error))
  }

  private watch(condition: number) {
    const error = new Error()
    this.idle.set(condition, () => noteIdle(error))
  }

  /** An operation by its number; a method's first operand is what it is called on. */
  call(operation: number, method: string, operands: readonly Expression[], isMethod = false) {
    const id = this.open(method)
    const few = operands.length <= 3 ? operands.length : 0
    const handle = (i: number) => (i < few ? operands[i]!.handle : 0)
    for (;;) {
      if (few < operands.length) this.push(id, operands)
      else if (this.idle.size) operands.forEach((operand) => this.use(operand))
      const result = this.core._call(id, operation, isMethod, few, handle(0), handle(1), handle(2))
      if (result !== needsPartials) {
        if (conditions.has(method)) {
          this.watch(result)
          this.conditions.add(result)
        }
        return this.expression(result)
      }
      this.givePartials(id)
    }
  }

  swizzle(name: string, value: Expression, indices: readonly number[]): Expression {
    const id = this.open(name)
    this.use(value)
    const packed = indices.reduce((bits, index, i) => bits | (index << (2 * i)), 0)
    const result = this.core._swizzle(id, value.handle, indices.length, packed)
    if (result === failed) throw new WarpError(`${name}: ${this.core.problem(id)}`)
    return this.expression(result)
  }

  /** With its text in each language that there is one in. */
  addFunction(hostFunction: HostFunction, sources: ReadonlyMap<string, string>): number {
    const { name, arity } = hostFunction
    const id = this.open('fn')
    for (const [language, text] of sources) this.core.addSource(id, language, text)
    const number = this.core.addFunction(id, name, arity)
    if (number === failed) this.refuse()
    this.functions[number] = hostFunction
    return number
  }

  callFunction(number: number, name: string, operands: readonly Expression[]): Expression {
    const id = this.open(name)
    this.push(id, operands)
    return this.expression(this.core._callFunction(id, number))
  }

  /** Functions that a front end recorded; no sketch writes them. */
  callRecorded(recorded: Recorded, operands: readonly Expression[]): Expression[] {
    const { name, variables, results, module } = recorded
    const { core } = this
    const id = this.open(name)
    let number = this.recorded.get(recorded)
    if (number === undefined) {
      const add = (at: number) => core.addRecorded(id, name, variables, at, module.length)
      this.recorded.set(recorded, (number = laid(core, module, add)))
    }
    this.push(id, operands)
    const first = core._callRecorded(id, number)
    return Array.from({ length: results }, (_, i) => this.expression(first + i))
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
    const id = this.open(name)
    this.push(id, operands)
    return this.expression(this.core._callNoise(id, kind, base, octaves, isMethod))
  }

  /** A loop: what its states are in the end, from what `body` makes of them in one step. */
  repeat(
    count: number,
    starts: readonly Expression[],
    body: (states: Expression[], step: Expression) => readonly Expression[],
    names: readonly string[],
  ): Expression[] {
    const id = this.open('repeat')
    const statesFrom = (handle: number) =>
      starts.map((_, i) => this.expression(handle === failed ? failed : handle + i))
    this.push(id, starts)
    const step = this.core._openRepeat(id, count)
    const states = statesFrom(step === failed ? failed : step + 1)
    let isOpen = true
    try {
      const nexts = body(states, this.expression(step))
      nexts.forEach((next, i) => {
        const [from, to] = [starts[i]!, next].map((each) => describeShape(this.shapeOf(each)))
        if (from !== to)
          throw new WarpError(
            `repeat: ${names[i]!} starts as ${from}, but the function makes it ${to}; start with ${to}.`,
          )
      })
      isOpen = false
      this.push(id, nexts)
      return statesFrom(this.core._closeRepeat(id))
    } finally {
      if (isOpen && !this.core.isBroken) this.core._dropRepeat(id)
    }
  }

  /** The host's image of that name at a vec2, with filter and wrap by number; `settings` is a vec3 that these may read. */
  callTexture(
    image: string,
    uv: Expression,
    filter: number,
    wrap: number,
    settings?: Expression,
  ): Expression {
    const id = this.open('texture')
    this.push(id, settings ? [uv, settings] : [uv])
    return this.expression(this.core.callTexture(id, image, filter, wrap))
  }

  /** A derivative meets calls of the host's functions: the sketch says what their partial derivatives are there. */
  private givePartials(id: SessionHandle) {
    const calls = Array.from({ length: this.core._pendingCount(id) }, (_, place) =>
      this.core._pendingCall(id, place),
    )
    for (const call of calls) this.givePartialsOf(id, call)
  }

  private givePartialsOf(id: SessionHandle, call: number) {
    const { name, arity, derivatives } = this.functions[this.core._functionOfCall(id, call)]!
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
      (_, i) => new Expression(this, this.core._argumentOfCall(id, call, i)),
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
    this.push(id, partials)
    if (!this.core._setPartials(id, call)) this.refuse()
  }

  /** Asks for a result by the method of an expression. */
  ask(name: unknown, value: Expression, method: string) {
    if (!this.recording.asks)
      throw new WarpError(
        `${method}: only gen takes results this way; return the expression from the function instead.`,
      )
    this.output(name, value, method)
  }

  /** Adds a result under a name. */
  output(name: unknown, value: Expression, method: string) {
    this.use(value)
    this.core.output(this.open(method), method, resultName(name, method), value.handle)
  }

  /** Asks for all results of a warp, from its offset and what src/warp calls its inputs. */
  warp(method: string, operands: readonly Expression[], turns: boolean, isFlat: boolean) {
    const id = this.open(method)
    for (;;) {
      this.push(id, operands)
      const result = this.core.warp(id, method, turns, isFlat)
      if (result === failed) this.refuse()
      if (result !== needsPartials) return { varies: !!result }
      this.givePartials(id)
    }
  }

  /** All that was built, as plain words. */
  finish(): KeptModule {
    const id = this.open('finish')
    if (!this.core._finish(id)) this.refuse()
    for (const note of this.idle.values()) note()
    const at = this.core._keptWords(id) / 4
    const words = this.core.HEAPU32.slice(at, at + this.core._keptSize(id))
    return Object.assign(words as KeptModule, { others: this.others })
  }
}

const conditions = new Set(['lt', 'le', 'gt', 'ge', 'eq', 'ne', 'and', 'or', 'not'])

/** The name of a result must be a text; whether it will do, a language says. */
export function resultName(name: unknown, method: string): string {
  if (typeof name === 'string') return name
  throw new WarpError(`${method}: the name of a result must be a text, but is ${describe(name)}.`)
}
