// Records one call of a callback: every operation calls the wasm, and returns an expression.
import { WarpError, describe } from '../../errors/errors.js'
import { text } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import type { Core } from '../../wasm/core.js'
import { failed, needsPartials } from '../../wasm/tables.js'
import type { SerializedModule, Target } from '../module/serialized-module.js'
import { Expression } from './expression.js'
import type { Operation } from './operations.js'
import { HostFunctions, type HostFunction } from './partials.js'
import type { HostSampling } from './sampling.js'
import type { ReadAsFloats, Shape } from './shapes.js'
import { WasmSession, type Recording } from './wasm-session.js'

/** A function of GLSL source, recorded in its own session, from numbers to numbers. */
export interface RecordedFunction {
  name: string
  /** The function is differentiated with respect to its first arguments; this is their number. */
  variables: number
  /** The number of floats that it returns. */
  results: number
  module: SerializedModule
}

const resultName = text()

export class Session extends WasmSession {
  /** Maps the number of an input that is not a float in the host → how it is read as floats. */
  private readonly conversions = new Map<number, ReadAsFloats>()
  /** Maps the shader's name of an image → the sampling that its host passes. */
  readonly samplings = new Map<string, HostSampling>()
  /** Maps the shader's name of a warp's input → the input's own name. */
  readonly inputNames = new Map<string, string>()
  private readonly hostFunctions = new HostFunctions(this)
  /** Maps a recorded function → its number in the session. */
  private readonly recorded = new Map<RecordedFunction, number>()
  /** The handles of conditions. */
  private readonly conditions = new Set<number>()

  constructor(
    /** The language of sources of `glsl.fn` that are plain strings. */
    readonly target: Target,
    recording: Recording = {},
  ) {
    super(recording)
  }

  /** Adds a variable of the host. `label` is the expression that reads it in the shader. */
  input(label: unknown, [columns, rows]: Shape, method: string): Expression {
    const session = this.requireOpen(method)
    if (typeof label !== 'string')
      throw new Place(method).expected('the name of a shader variable', describe(label))
    return this.expression(session.input(method, label, columns, rows))
  }

  /** Adds a variable of the host that does not consist of floats. */
  inputOf(read: ReadAsFloats, shape: Shape, method: string): Expression {
    const input = this.input(read.texts[this.target], shape, method)
    this.conversions.set(this.numberOf(input), read)
    return input
  }

  /** Tests for a condition: the result of a comparison or of a logical operation. */
  isCondition({ handle }: Expression): boolean {
    return this.conditions.has(handle)
  }

  /** Copies an expression such that unused results of the copy's methods cause a warning. */
  copyOf({ handle }: Expression): Expression {
    const copy = new Expression(this, handle)
    this.unused.addCopy(copy)
    return copy
  }

  /** Must be called with the result of every method, to find unused results of methods of copies. */
  followCopy(copy: Expression, name: string, result: unknown) {
    this.unused.follow(copy, name, result)
  }

  /** Applies an operation. The first operand of a method is the expression that it is called on. */
  call(operation: Operation, operands: readonly Expression[], isMethod = false): Expression {
    const { name, number, isCondition } = operation
    const address = this.openAddress(name)
    // Up to three operands are arguments of the call; more are pushed before it.
    const count = operands.length <= 3 ? operands.length : 0
    const a = count > 0 ? operands[0]!.handle : 0
    const b = count > 1 ? operands[1]!.handle : 0
    const c = count > 2 ? operands[2]!.handle : 0
    for (;;) {
      if (count < operands.length) this.push(operands)
      else if (this.unused.size > 0) for (const operand of operands) this.unused.use(operand)
      const result = this.core._call(address, number, +isMethod, count, a, b, c)
      if (result !== needsPartials) {
        if (isCondition) {
          this.unused.watch(result)
          this.conditions.add(result)
        }
        return this.expression(result)
      }
      this.addPartials()
    }
  }

  swizzle(name: string, value: Expression, indices: readonly number[]): Expression {
    const session = this.requireOpen(name)
    this.unused.use(value)
    const packed = indices.reduce((bits, index, i) => bits | (index << (2 * i)), 0)
    const result = this.core._swizzle(this.address, value.handle, indices.length, packed)
    if (result === failed) throw new WarpError(`${name}: ${session.problem()}`)
    return this.expression(result)
  }

  /** Declares a function of the host. `sources` maps a language → source. */
  addFunction(hostFunction: HostFunction, sources: ReadonlyMap<string, string>): number {
    const { name, arity } = hostFunction
    const number = this.requireOpen('fn').addFunction(name, [...sources], arity)
    if (number === failed) this.fail()
    this.hostFunctions.add(number, hostFunction)
    return number
  }

  callFunction(number: number, name: string, operands: readonly Expression[]): Expression {
    const address = this.openAddress(name)
    this.push(operands)
    return this.expression(this.core._callFunction(address, number))
  }

  /** Calls a function that a front end recorded. */
  callRecorded(recorded: RecordedFunction, operands: readonly Expression[]): Expression[] {
    const { name, variables, results, module } = recorded
    const session = this.requireOpen(name)
    let number = this.recorded.get(recorded)
    if (number === undefined)
      this.recorded.set(recorded, (number = session.addRecorded(name, variables, module)))
    this.push(operands)
    const first = session.callRecorded(number)
    return Array.from({ length: results }, (_, i) => this.expression(first + i))
  }

  /** Calls a noise by number. The operands are a point, a seed and, for fractals, lacunarity and gain. */
  callNoise(
    kind: number,
    base: number,
    octaves: number,
    name: string,
    operands: readonly Expression[],
    isMethod: boolean,
  ): Expression {
    const address = this.openAddress(name)
    this.push(operands)
    return this.expression(this.core._callNoise(address, kind, base, octaves, +isMethod))
  }

  /** Adds a loop, and returns the final states. `body` gets the states of a step, and returns the states of the next step. */
  repeat(
    count: number,
    starts: readonly Expression[],
    body: (states: Expression[], step: Expression) => readonly Expression[],
  ): Expression[] {
    const session = this.requireOpen('repeat')
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

  /** Reads an image of the host at a vec2. `settings`, the vec3 of `samplingUniforms`, is required if `filter` or `wrap` is 'host'. */
  callTexture(
    image: string,
    uv: Expression,
    filter: keyof Core['Filter'],
    wrap: keyof Core['Wrap'],
    settings?: Expression,
  ): Expression {
    const { Filter, Wrap } = this.core
    const session = this.requireOpen('texture')
    this.push(settings ? [uv, settings] : [uv])
    return this.expression(session.callTexture(image, Filter[filter], Wrap[wrap]))
  }

  /** Returns the width and height of an image of the host, which each language writes in its own way. */
  imageSize(image: string): Expression {
    return this.expression(this.requireOpen('texture').imageSize(image))
  }

  /** Adds the partial derivatives of the calls of the host's functions that a derivative depends on. */
  private addPartials() {
    const session = this.requireOpen('derivative')
    for (const call of session.pendingCalls()) {
      this.push(this.hostFunctions.partialsOf(session, call))
      if (!session.setPartials(call)) this.fail()
    }
  }

  /** Adds a result by a method of an expression, which only `gen` allows. */
  requestOutput(name: unknown, value: Expression, place: Place) {
    if (!this.recording.hasOutputMethods)
      throw place.error(
        'only gen takes results this way; return the expression from the function instead.',
      )
    this.output(name, value, place)
  }

  /** Adds a result. The module checks the name when shader code is written, since languages have different reserved words. */
  output(name: unknown, value: Expression, place: Place) {
    this.unused.use(value)
    const label = resultName.read(name, place.part('the name of a result'))
    this.requireOpen(place.method).output(place.method, label, value.handle)
  }

  /**
   * Adds all results of a warp. The operands are the warp's offset and the `warpOperands` of wasm/tables.ts. If `isFlat`, also computes
   * the normals that treat normal and uv as constant; see warp.hpp.
   */
  warp(place: Place, operands: readonly Expression[], hasNormals: boolean, isFlat: boolean) {
    const session = this.requireOpen(place.method)
    for (;;) {
      this.push(operands)
      const result = session.warp(place.method, hasNormals, isFlat)
      if (result === failed) this.fail()
      if (result !== needsPartials) return { varies: !!result }
      this.addPartials()
    }
  }

  /** Returns all results as a serialized module. */
  finish(): SerializedModule {
    const words = this.requireOpen('finish').finish()
    if (!words.length) this.fail()
    this.unused.warnAll()
    return Object.assign(words as SerializedModule, { conversions: this.conversions })
  }
}
