// The lifetime of a wasm module bound by embind: it starts when it is first used, and is replaced after a failure.
import { WarpError } from '../errors/errors.js'
import { withBytes } from './inlined.js'

/** The members of every module besides its bindings. The arrays are views of its memory, which are replaced when it grows. */
export interface Emscripten {
  _malloc(bytes: number): number
  _free(address: number): void
  readonly HEAPU8: Uint8Array
  readonly HEAPU32: Uint32Array
  readonly HEAPF32: Float32Array
  readonly HEAPF64: Float64Array
  /** The exports, under minified names. */
  readonly asm: WebAssembly.Exports
  /** `true` after a failure: the memory is in an undefined state, and no function may be called again. */
  isBroken: boolean
}

/** A C++ object bound by embind. */
interface Handle {
  delete(): void
}

/** The function that Emscripten generates for a module, which makes instances. */
export type Factory = (options: {
  wasmBinary: Uint8Array
  /** Prints nothing, since errors are thrown. */
  printErr: () => void
  /** Converts an error in a bound function into the one to throw; see .cmake/embind-invoker.js. */
  fail: (error: unknown) => unknown
}) => unknown

interface Options {
  factory: Factory
  inlined: string
  /** Makes the error to throw when the instance has failed. `megabytes` is the size of its memory. */
  fail: (cause: unknown, megabytes: number) => unknown
  /** Makes the error to throw if the module does not start for a reason that `withBytes` does not explain. */
  explainStart?: (cause: unknown) => Error | false
  /** Memory never shrinks: an instance with more memory is replaced after use. Default: no limit. */
  maxKeptBytes?: number
}

/** Explains why a module with SIMD does not start in an old browser. `user` is what needs it. */
export const explainNoSimd = (user: string) => (cause: unknown) =>
  cause instanceof WebAssembly.CompileError &&
  new WarpError(
    `${user} needs WebAssembly with SIMD, which this browser lacks; update it (Chrome 114, Firefox 89, Safari 16.4 and Node have it).`,
  )

export class WasmInstance<Bound extends Emscripten> {
  private instance: Bound | undefined

  constructor(private readonly options: Options) {}

  get(): Bound {
    return (this.instance ??= this.start())
  }

  /** Makes a C++ object, calls `work` with it, and deletes it, also if `work` throws. */
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
    if (this.instance === bound) this.instance = undefined
  }

  private start(): Bound {
    const { factory, inlined, explainStart } = this.options
    const fail = (error: unknown) => this.failure(bound, error)
    let module: Bound
    try {
      module = withBytes(inlined, (wasmBinary) =>
        factory({ wasmBinary, printErr() {}, fail }),
      ) as Bound
    } catch (cause) {
      throw (!(cause instanceof WarpError) && explainStart?.(cause)) || cause
    }
    // Engines treat Emscripten's object as a slow dictionary. As the prototype of another object, its functions are fast to look up.
    const bound: Bound = Object.assign(Object.create(module), { isBroken: false })
    for (const [name, call] of Object.entries(module))
      if (/^_[a-z]/.test(name)) Reflect.set(module, name, this.guard(bound, call as never))
    return bound
  }

  /**
   * Wraps a plain export so that failures are handled; bound functions are wrapped already. Seven parameters are enough for all
   * exports, and take half the time of a rest parameter.
   */
  guard<Call extends (...args: never[]) => unknown>(bound: Bound, call: Call): Call {
    const plain = call as unknown as (...args: unknown[]) => unknown
    const guarded: typeof plain = (a, b, c, d, e, f, g) => {
      try {
        return plain(a, b, c, d, e, f, g)
      } catch (error) {
        throw this.failure(bound, error)
      }
    }
    return guarded as unknown as Call
  }

  /** Returns the error to throw for an error of `bound`. A trap means that `bound` has failed. */
  private failure(bound: Bound, error: unknown): unknown {
    if (!isTrap(error)) return error
    bound.isBroken = true
    this.drop(bound)
    return this.options.fail(error, Math.ceil(bound.HEAPU8.length / 2 ** 20))
  }
}

/** Makes a `fail` that reports lack of memory. A stack overflow means endless recursion of user code, which JavaScript's own error
 * describes better. */
export const outOfMemory =
  (message: (megabytes: number) => string) => (cause: unknown, megabytes: number) =>
    cause instanceof RangeError ? cause : new WarpError(message(megabytes))

/** Returns whether an error means that the instance has failed: a trap, a stack overflow, lack of memory, or an uncaught C++ exception. */
const isTrap = (error: unknown) =>
  error instanceof WebAssembly.RuntimeError ||
  error instanceof RangeError ||
  (typeof WebAssembly.Exception === 'function' && error instanceof WebAssembly.Exception)
