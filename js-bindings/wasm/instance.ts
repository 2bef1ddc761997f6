// The life of a wasm module that embind binds: it starts when it is first used, and is replaced once it has failed.
import { WarpError } from '../errors/errors.js'
import { type Inlined, withBytes } from './inlined.js'

/** What every module has besides its bindings. The arrays are views of its memory, which are new whenever that has grown. */
export interface Emscripten {
  _malloc(bytes: number): number
  _free(address: number): void
  readonly HEAPU8: Uint8Array
  readonly HEAPU32: Uint32Array
  readonly HEAPF32: Float32Array
  readonly HEAPF64: Float64Array
  /** The exports, under minified names. */
  readonly asm: WebAssembly.Exports
  /** Whether it has failed, so that its memory is in any state and nothing of it may run again. */
  isBroken: boolean
}

/** An object of C++. */
interface Handle {
  delete(): void
}

/** What Emscripten generates for a module: it makes instances. */
export type Factory = (options: {
  wasmBinary: Uint8Array
  /** Nothing is printed; what is wrong is thrown. */
  printErr: () => void
  /** Makes what is thrown of an error in a bound function; see .cmake/embind-invoker.js. */
  fail: (error: unknown) => unknown
}) => unknown

interface Options {
  factory: Factory
  inlined: Inlined
  /** Makes the error to throw when the instance has failed while it held so many megabytes. */
  fail: (cause: unknown, megabytes: number) => unknown
  /** Makes the error to throw if the module does not start for a reason that `withBytes` does not know. */
  explainStart?: (cause: unknown) => Error | false
  /** Memory only grows: an instance that holds more after its use is replaced. */
  maxKeptBytes?: number
}

export class WasmInstance<Bound extends Emscripten> {
  private present: Bound | undefined

  constructor(private readonly options: Options) {}

  get(): Bound {
    return (this.present ??= this.start())
  }

  /** Does `work` with an object of C++, and deletes it whatever happens. */
  use<Owned extends Handle, Result>(
    make: (bound: Bound) => Owned,
    work: (owned: Owned, bound: Bound) => Result,
  ): Result {
    const bound = this.get()
    let owned: Owned | undefined
    try {
      owned = make(bound)
      return work(owned, bound)
    } finally {
      if (!bound.isBroken) owned?.delete()
      if (bound.HEAPU8.length > (this.options.maxKeptBytes ?? Infinity)) this.drop(bound)
    }
  }

  private drop(bound: Bound) {
    if (this.present === bound) this.present = undefined
  }

  private start(): Bound {
    const { factory, inlined, explainStart } = this.options
    const fail = (error: unknown) => this.failure(bound, error)
    let made: Bound
    try {
      made = withBytes(inlined, (wasmBinary) =>
        factory({ wasmBinary, printErr() {}, fail }),
      ) as Bound
    } catch (cause) {
      throw (!(cause instanceof WarpError) && explainStart?.(cause)) || cause
    }
    // Emscripten's object is a mere dictionary to an engine; as a prototype, its functions are found at once.
    const bound: Bound = Object.assign(Object.create(made), { isBroken: false })
    for (const [name, call] of Object.entries(made))
      if (/^_[a-z]/.test(name)) Reflect.set(made, name, this.guard(bound, call as never))
    return bound
  }

  /**
   * A plain export with what becomes of a failure in it; bound functions have that already. Seven places are enough for all of
   * them, and take half the time of a list.
   */
  guard<Call extends (...given: never[]) => unknown>(bound: Bound, call: Call): Call {
    const plain = call as unknown as (...given: unknown[]) => unknown
    const guarded: typeof plain = (a, b, c, d, e, f, g) => {
      try {
        return plain(a, b, c, d, e, f, g)
      } catch (error) {
        throw this.failure(bound, error)
      }
    }
    return guarded as unknown as Call
  }

  /** Returns what to throw for an error of `bound`, which has failed if it is a trap. */
  private failure(bound: Bound, error: unknown): unknown {
    if (!isTrap(error)) return error
    bound.isBroken = true
    this.drop(bound)
    return this.options.fail(error, Math.ceil(bound.HEAPU8.length / 2 ** 20))
  }
}

/** A `fail` for want of memory. No more stack means that user code calls itself without end, which JavaScript says better. */
export const outOfMemory =
  (message: (megabytes: number) => string) => (cause: unknown, megabytes: number) =>
    cause instanceof RangeError ? cause : new WarpError(message(megabytes))

/** What stops an instance: a trap, no more stack, no more memory, or an exception of C++ that nothing caught. */
const isTrap = (error: unknown) =>
  error instanceof WebAssembly.RuntimeError ||
  error instanceof RangeError ||
  (typeof WebAssembly.Exception === 'function' && error instanceof WebAssembly.Exception)
