// One run of a sketch's function: the session in the wasm, which holds all that the sketch built so far. It is closed when
// the callback is over, whatever happened.
import { type Core, type Session as CoreSession, core as instance } from '../../wasm/core.js'
import { WarpError, describe } from '../../errors/errors.js'
import { Expression } from './expression.js'
import type { SerializedModule, Target } from '../module/serialized-module.js'
import { Place } from '../../options/place.js'
import type { Operation } from './operations.js'
import type { ReadAsFloats, Shape } from './shapes.js'
import { callerOutside } from '../../errors/source-lines.js'
import { type HostFunction, partialsOf } from './partials.js'
import type { HostSampling } from './sampling.js'
import { UnusedExpressions } from './unused.js'
import { failed, needsPartials } from '../../wasm/tables.js'

/** A function of shader text, recorded by itself: numbers go in and come out. */
export interface Recorded {
  name: string
  /** How many of its arguments, the first ones, it has derivatives by. */
  variables: number
  results: number
  module: SerializedModule
}

/** How a run is recorded. */
export interface Recording {
  /** Whether expressions ask for results by `.output(name)`, as `gen` alone has it. */
  asks?: boolean
  /** Whether statements say which lines of the sketch they are from. */
  debug?: boolean
}

export class Session {
  /** Maps the number of an input that is not a float in the host → how it is read as floats. */
  private readonly conversions = new Map<number, ReadAsFloats>()
  /** Maps the shader's name of an image → the sampling that its host passes. */
  readonly samplings = new Map<string, HostSampling>()
  /** Maps the shader's name of an input of a warp → the input that it is. */
  readonly inputNames = new Map<string, string>()
  /** The functions of the host, by their number. */
  readonly functions: HostFunction[] = []
  private readonly core: Core = instance.get()
  private readonly recorded = new Map<Recorded, number>()
  private session: CoreSession | undefined
  /** Of `session`, for plain exports. */
  private readonly address: number
  private readonly unused = new UnusedExpressions()
  /** The handles of conditions. */
  private readonly conditions = new Set<number>()
  /** How many functions' derivatives are being asked for at this moment. */
  private nesting = 0

  constructor(
    /** The language of texts of the sketch that do not say theirs. */
    readonly target: Target,
    private readonly recording: Recording = {},
  ) {
    this.session = new this.core.Session()
    this.address = this.session.address()
  }

  close() {
    if (!this.core.isBroken) this.session?.delete()
    this.session = undefined
  }

  private open(method: string): CoreSession {
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

  /** The address of the open session. */
  private at(method: string): number {
    this.open(method)
    return this.address
  }

  private refuse(): never {
    throw new WarpError(this.open('problem').problem())
  }

  private expression(handle: number): Expression {
    if (handle === failed) this.refuse()
    if (this.recording.debug) this.open('debug').comment(callerOutside())
    return new Expression(this, handle)
  }

  shapeOf(value: Expression): Shape {
    const shape = this.core._shapeOf(this.at('shape'), value.handle)
    return [shape >> 4, shape & 15]
  }

  /** The number of an input in the module. */
  numberOf(input: Expression): number {
    return this.core._inputOf(this.at('number'), input.handle)
  }

  /** A number that float32 can hold; see `toExpression`. */
  constant(value: number, method: string): Expression {
    return this.expression(this.core._constant(this.at(method), value))
  }

  /** A variable of the host, by the expression that reads it there. */
  input(label: unknown, [columns, rows]: Shape, method: string): Expression {
    const session = this.open(method)
    if (typeof label !== 'string')
      throw new Place(method).expected('the name of a shader variable', describe(label))
    return this.expression(session.input(method, label, columns, rows))
  }

  /** A variable of the host that has another type than floats. */
  inputOf(read: ReadAsFloats, shape: Shape, method: string): Expression {
    const input = this.input(read.texts[this.target], shape, method)
    this.conversions.set(this.numberOf(input), read)
    return input
  }

  private push(operands: readonly Expression[]) {
    for (const operand of operands) {
      this.core._push(this.address, operand.handle)
      this.unused.use(operand)
    }
  }

  /** Returns whether a value is a condition: the result of a comparison, or of logic. */
  isCondition({ handle }: Expression): boolean {
    return this.conditions.has(handle)
  }

  /** Copies the handle, so that a later call on the copy whose result is unused can be noted, as for a p5.Vector. */
  copyOf({ handle }: Expression): Expression {
    const copy = new Expression(this, handle)
    this.unused.addCopy(copy)
    return copy
  }

  /** To be called with what a method gave. */
  followCopy(copy: Expression, method: string, result: unknown) {
    this.unused.follow(copy, method, result)
  }

  /** Applies an operation; a method's first operand is what it is called on. */
  call(operation: Operation, operands: readonly Expression[], isMethod = false): Expression {
    const { name, number, isCondition } = operation
    const at = this.at(name)
    // Up to three operands are arguments of the call; more are pushed before it.
    const count = operands.length <= 3 ? operands.length : 0
    const a = count > 0 ? operands[0]!.handle : 0
    const b = count > 1 ? operands[1]!.handle : 0
    const c = count > 2 ? operands[2]!.handle : 0
    for (;;) {
      if (count < operands.length) this.push(operands)
      else if (this.unused.size > 0) for (const operand of operands) this.unused.use(operand)
      const result = this.core._call(at, number, +isMethod, count, a, b, c)
      if (result !== needsPartials) {
        if (isCondition) {
          this.unused.watch(result)
          this.conditions.add(result)
        }
        return this.expression(result)
      }
      this.givePartials()
    }
  }

  swizzle(name: string, value: Expression, indices: readonly number[]): Expression {
    const session = this.open(name)
    this.unused.use(value)
    const packed = indices.reduce((bits, index, i) => bits | (index << (2 * i)), 0)
    const result = this.core._swizzle(this.address, value.handle, indices.length, packed)
    if (result === failed) throw new WarpError(`${name}: ${session.problem()}`)
    return this.expression(result)
  }

  /** With its text in each language that there is one in. */
  addFunction(hostFunction: HostFunction, sources: ReadonlyMap<string, string>): number {
    const { name, arity } = hostFunction
    const number = this.open('fn').addFunction(name, [...sources], arity)
    if (number === failed) this.refuse()
    this.functions[number] = hostFunction
    return number
  }

  callFunction(number: number, name: string, operands: readonly Expression[]): Expression {
    const at = this.at(name)
    this.push(operands)
    return this.expression(this.core._callFunction(at, number))
  }

  /** Functions that a front end recorded; no sketch writes them. */
  callRecorded(recorded: Recorded, operands: readonly Expression[]): Expression[] {
    const { name, variables, results, module } = recorded
    const session = this.open(name)
    let number = this.recorded.get(recorded)
    if (number === undefined)
      this.recorded.set(recorded, (number = session.addRecorded(name, variables, module)))
    this.push(operands)
    const first = session.callRecorded(number)
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
    const at = this.at(name)
    this.push(operands)
    return this.expression(this.core._callNoise(at, kind, base, octaves, +isMethod))
  }

  /** A loop: what its states are in the end, from what `body` makes of them in one step. */
  repeat(
    count: number,
    starts: readonly Expression[],
    body: (states: Expression[], step: Expression) => readonly Expression[],
  ): Expression[] {
    const session = this.open('repeat')
    const statesFrom = (handle: number) =>
      starts.map((_, i) => this.expression(handle === failed ? failed : handle + i))
    this.push(starts)
    const step = session.openRepeat(count)
    const states = statesFrom(step === failed ? failed : step + 1)
    let isOpen = true
    try {
      const nexts = body(states, this.expression(step))
      isOpen = false
      this.push(nexts)
      return statesFrom(session.closeRepeat())
    } finally {
      if (isOpen && !this.core.isBroken) session.dropRepeat()
    }
  }

  /** The host's image of that name at a vec2; `settings` is a vec3 that filter and wrap may read. */
  callTexture(
    image: string,
    uv: Expression,
    filter: keyof Core['Filter'],
    wrap: keyof Core['Wrap'],
    settings?: Expression,
  ): Expression {
    const { Filter, Wrap } = this.core
    const session = this.open('texture')
    this.push(settings ? [uv, settings] : [uv])
    return this.expression(session.callTexture(image, Filter[filter], Wrap[wrap]))
  }

  /** A derivative meets calls of the host's functions: the sketch says what their partial derivatives are there. */
  private givePartials() {
    for (const call of this.open('derivative').pendingCalls()) this.givePartialsOf(call)
  }

  private givePartialsOf(call: number) {
    const session = this.open('derivative')
    const called = this.functions[session.functionOfCall(call)]!
    const operands = Array.from(
      { length: called.arity },
      (_, i) => new Expression(this, session.argumentOfCall(call, i)),
    )
    if (this.nesting === 100)
      throw new WarpError(
        `${called.name}: its derivative needs a derivative of itself; write it with calls of functions instead.`,
      )
    this.nesting++
    let partials: Expression[]
    try {
      partials = partialsOf(this, called, operands)
    } finally {
      this.nesting--
    }
    this.push(partials)
    if (!session.setPartials(call)) this.refuse()
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
    this.unused.use(value)
    this.open(method).output(method, resultName(name, method), value.handle)
  }

  /** Asks for all results of a warp, from its offset and what src/warp calls its inputs. */
  warp(method: string, operands: readonly Expression[], turns: boolean, isFlat: boolean) {
    const session = this.open(method)
    for (;;) {
      this.push(operands)
      const result = session.warp(method, turns, isFlat)
      if (result === failed) this.refuse()
      if (result !== needsPartials) return { varies: !!result }
      this.givePartials()
    }
  }

  /** All that was built, as plain words. */
  finish(): SerializedModule {
    const words = this.open('finish').finish()
    if (!words.length) this.refuse()
    this.unused.noteAll()
    return Object.assign(words as SerializedModule, { conversions: this.conversions })
  }
}

/** The name of a result must be a text; whether it will do, a language says. */
export function resultName(name: unknown, method: string): string {
  if (typeof name === 'string') return name
  throw new Place(method, 'the name of a result').expected('a text', describe(name))
}
