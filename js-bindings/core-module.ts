// Starts the compiler's wasm by hand: the JavaScript that Emscripten would write for it is four times as large.
import { WarpError } from './errors.js'
import base64 from './generated/core-wasm.js'
import { open } from './wasm.js'

interface Exports extends Record<string, unknown> {
  memory: WebAssembly.Memory
  __indirect_function_table: WebAssembly.Table
  /** Runs C++'s constructors, which tell embind what there is. */
  _initialize(): void
  allocate(bytes: number): number
  release(address: number): void
}

/**
 * Every exported C function with a `_` before its name, every function of embind, and the memory as arrays. `giveUp` is
 * called when the instance has stopped, for want of memory: what it holds may then be in any state.
 */
export function startCore<Core>(giveUp: () => void): Core {
  const functions: Record<string, unknown> = {}
  // By the address that stands for the type.
  const textTypes = new Set<number>()
  const env = {
    ...mathematics(),
    emscripten_notify_memory_growth() {},
    _embind_register_std_string: (type: number) => textTypes.add(type),
    _embind_register_function(
      name: number,
      count: number,
      types: number,
      _signature: number,
      invoker: number,
      context: number,
    ) {
      const call = exports.__indirect_function_table.get(invoker) as (...values: unknown[]) => never
      const isText = Array.from(words().subarray(types / 4, types / 4 + count), (type) =>
        textTypes.has(type),
      )
      functions[textUntilZero(name)] = guarded(embound(call, context, isText))
    },
  }
  const module = open(base64)
  const exports = new WebAssembly.Instance(module, {
    env,
    wasi_snapshot_preview1: { proc_exit },
  }).exports as Exports

  const bytes = () => new Uint8Array(exports.memory.buffer)
  const words = () => new Uint32Array(exports.memory.buffer)
  const textOf = (start: number, size: number) =>
    new TextDecoder().decode(bytes().subarray(start, start + size))
  const textUntilZero = (start: number) => textOf(start, bytes().indexOf(0, start) - start)

  /**
   * A function as embind calls it. The type of the result comes first. WebAssembly's own conversions do for all but
   * texts, which cross as the address of a length and so many bytes of UTF-8.
   */
  function embound(
    call: (...values: unknown[]) => never,
    context: number,
    [givesText, ...takesText]: boolean[],
  ) {
    return (...given: unknown[]): unknown => {
      const texts: number[] = []
      const values = given.map((value, i) => {
        if (!takesText[i]) return value
        const text = new TextEncoder().encode(value as string)
        const address = exports.allocate(4 + text.length)
        if (!address) proc_exit()
        texts.push(address)
        words()[address / 4] = text.length
        bytes().set(text, address + 4)
        return address
      })
      const result: number = call(context, ...values)
      for (const address of texts) exports.release(address)
      if (!givesText) return result
      const text = textOf(result + 4, words()[result / 4]!)
      exports.release(result)
      return text
    }
  }

  function guarded<Given extends unknown[]>(call: (...given: Given) => unknown) {
    return (...given: Given) => {
      try {
        return call(...given)
      } catch (error) {
        if (!isTrap(error)) throw error
        if (!functions.isBroken) giveUp()
        functions.isBroken = true
        // No more stack: the sketch calls itself without end, which JavaScript says better.
        if (error instanceof RangeError) throw error
        const megabytes = Math.ceil(exports.memory.buffer.byteLength / 2 ** 20)
        throw new WarpError(
          `There is not enough memory for so large a warp: the compiler already holds ${megabytes} MB.`,
        )
      }
    }
  }

  exports._initialize()
  for (const [name, value] of Object.entries(exports))
    if (typeof value === 'function') functions[`_${name}`] = guarded(value as () => unknown)
  return Object.defineProperties(functions, {
    HEAPU32: { get: words },
    HEAPF64: { get: () => new Float64Array(exports.memory.buffer) },
  }) as Core
}

const isTrap = (error: unknown) =>
  error instanceof WebAssembly.RuntimeError || error instanceof RangeError

/** C's functions, under the names that Emscripten's -sJS_MATH and .cmake/math.cpp give them. */
function mathematics() {
  const names = Object.getOwnPropertyNames(Math) as Exclude<keyof Math, symbol>[]
  return {
    ...Object.fromEntries(
      names.flatMap((name) => [
        [`JS_${name}`, Math[name]],
        [`emscripten_math_${name}`, Math[name]],
      ]),
    ),
    // C rounds halves away from zero.
    JS_round: (x: number) => (x >= 0 ? Math.floor(x + 0.5) : Math.ceil(x - 0.5)),
  }
}

/** How a C++ program ends, which ours does only where memory does. */
function proc_exit(): never {
  throw new WebAssembly.RuntimeError('warpjet has no more memory')
}
