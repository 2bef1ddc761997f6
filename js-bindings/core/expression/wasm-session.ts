// The session in the wasm, which holds all nodes that a callback has built. It is closed when the callback returns or throws.
import { WarpError } from '../../errors/errors.js'
import { callerLine } from '../../errors/source-lines.js'
import type { Place } from '../../options/place.js'
import { core as instance, type Core, type Session as CoreSession } from '../../wasm/core.js'
import { failed } from '../../wasm/tables.js'
import { Expression } from './expression.js'
import type { Shape } from './shapes.js'
import { UnusedExpressions } from './unused.js'

/** Options for recording a callback. */
export interface Recording {
  /** True if expressions request results by `.output(name)`, as in `gen`. */
  hasOutputMethods?: boolean
  /** True if comments say which line of the user's code each statement comes from. */
  debug?: boolean
}

export class WasmSession {
  protected readonly core: Core = instance.get()
  protected readonly unused = new UnusedExpressions()
  private session: CoreSession | undefined
  /** The address of `session`, for plain exports. */
  protected readonly address: number

  constructor(protected readonly recording: Recording) {
    this.session = new this.core.Session()
    this.address = this.session.address()
  }

  close() {
    if (!this.core.isBroken) this.session?.delete()
    this.session = undefined
  }

  /** Returns the session. Throws if it is closed. `call` is the name of the called function, for the message. */
  protected requireOpen(call: string): CoreSession {
    if (!this.session)
      throw new WarpError(
        `${call}: the function that made this expression is over; use expressions only inside it.`,
      )
    if (this.core.isBroken)
      throw new WarpError(
        `${call}: the compiler ran out of memory, and this warp was lost with it; make it again.`,
      )
    return this.session
  }

  /** Returns the address of the session. Throws if it is closed. */
  protected openAddress(call: string): number {
    this.requireOpen(call)
    return this.address
  }

  /** Throws the problem that the session describes. */
  protected fail(): never {
    throw new WarpError(this.requireOpen('problem').problem())
  }

  /** Makes the expression of a handle. Throws the session's problem if the handle is `failed`. */
  protected expression(handle: number): Expression {
    if (handle === failed) this.fail()
    if (this.recording.debug) this.requireOpen('debug').comment(callerLine())
    return new Expression(this, handle)
  }

  /** Passes operands to the wasm, for the next call. */
  protected push(operands: readonly Expression[]) {
    for (const operand of operands) {
      this.core._push(this.address, operand.handle)
      this.unused.use(operand)
    }
  }

  shapeOf(value: Expression): Shape {
    const shape = this.core._shapeOf(this.openAddress('shape'), value.handle)
    return [shape >> 4, shape & 15]
  }

  /** Returns the number of an input in the module. */
  numberOf(input: Expression): number {
    return this.core._inputOf(this.openAddress('number'), input.handle)
  }

  /** Makes a constant, which float32 must be able to represent; see `toExpression`. */
  constant(value: number, place: Place): Expression {
    return this.expression(this.core._constant(this.openAddress(place.method), value))
  }
}
