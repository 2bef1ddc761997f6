// Loads the compiler. Nothing happens before the first warp.
import { WarpError } from '../errors/errors.js'
import { startCore } from './core-calls.js'
import { megabytesOf } from './start.js'

/** A run of a sketch's function inside the wasm: an address, to be closed. */
export type SessionHandle = number & { readonly session: unique symbol }

/** A module that was kept, read again inside the wasm: an address, to be closed. */
export type Reading = number & { readonly reading: unique symbol }

/**
 * core.cpp. Handles stand for values, numbers, vectors and matrices alike; `failed` of tables.ts stands in the place
 * of one that there cannot be, and then `problem` says why.
 */
export interface Core {
  _openSession(): SessionHandle
  _constant(session: SessionHandle, value: number): number
  _push(session: SessionHandle, handle: number): void
  _call(
    session: SessionHandle,
    operation: number,
    isMethod: boolean,
    count: number,
    a: number,
    b: number,
    c: number,
  ): number
  _callFunction(session: SessionHandle, hostFunction: number): number
  _callNoise(
    session: SessionHandle,
    kind: number,
    base: number,
    octaves: number,
    isMethod: boolean,
  ): number
  _callRecorded(session: SessionHandle, recorded: number): number
  _openRepeat(session: SessionHandle, steps: number): number
  _closeRepeat(session: SessionHandle): number
  _dropRepeat(session: SessionHandle): void
  _swizzle(session: SessionHandle, handle: number, count: number, indices: number): number
  _pendingCount(session: SessionHandle): number
  _pendingCall(session: SessionHandle, place: number): number
  _functionOfCall(session: SessionHandle, call: number): number
  _argumentOfCall(session: SessionHandle, call: number, i: number): number
  _setPartials(session: SessionHandle, call: number): number
  _inputOf(session: SessionHandle, handle: number): number
  _shapeOf(session: SessionHandle, handle: number): number
  _finish(session: SessionHandle): number
  _keptWords(session: SessionHandle): number
  _keptSize(session: SessionHandle): number
  _closeSession(session: SessionHandle): void
  _openReading(words: number, size: number): Reading
  _closeReading(reading: Reading): void
  _nodeCount(reading: Reading): number
  _operationCount(reading: Reading): number
  _temporaryCount(reading: Reading): number
  _vectorCount(reading: Reading): number
  _knowInput(reading: Reading, number: number): void
  _separate(reading: Reading): number
  _wantResult(reading: Reading, number: number): void
  _makeProgram(reading: Reading): number
  _programReads(reading: Reading, first: number, count: number): number
  _programWords(reading: Reading): number
  _programSize(reading: Reading): number
  _instructionCount(reading: Reading): number
  _run(
    words: number,
    size: number,
    instructions: number,
    inputs: number,
    inputCount: number,
    results: number,
    resultCount: number,
  ): void
  _allocate(bytes: number): number
  _release(memory: number): void
  _memoryInUse(): number

  operationNames(): string
  problem(session: SessionHandle): string
  input(
    session: SessionHandle,
    method: string,
    label: string,
    columns: number,
    rows: number,
  ): number
  callTexture(session: SessionHandle, image: string, filter: number, wrap: number): number
  addSource(session: SessionHandle, language: string, text: string): void
  addFunction(session: SessionHandle, name: string, arity: number): number
  addRecorded(
    session: SessionHandle,
    name: string,
    variables: number,
    words: number,
    size: number,
  ): number
  comment(session: SessionHandle, text: string): void
  output(session: SessionHandle, method: string, name: string, handle: number): void
  warp(session: SessionHandle, method: string, turns: boolean, isFlat: boolean): number
  nameInput(reading: Reading, number: number, text: string): void
  nameResult(reading: Reading, number: number, text: string): void
  writeText(reading: Reading, target: string, maxDepth: number): number
  readingProblem(reading: Reading): string
  code(reading: Reading): string
  declarations(reading: Reading): string
  inputLines(reading: Reading): string
  allInputLines(reading: Reading): string
  outputLines(reading: Reading): string

  /** Whether it ran out of memory, and nothing of it may be used any more. */
  isBroken?: boolean

  readonly HEAPU32: Uint32Array
  readonly HEAPF64: Float64Array
}

let core: Core | undefined

export function getCore(): Core {
  return (core ??= startCore<Core>(giveUp))
}

/** What `read` makes of words of a module, which are in the wasm's memory meanwhile. */
export function laid<Result>(core: Core, words: Uint32Array, read: (memory: number) => Result) {
  const memory = core._allocate(4 * words.length)
  if (!memory)
    throw new WarpError(
      `There is not enough memory to write so large a warp: the compiler already holds ${megabytesOf(core.HEAPU32)} MB.`,
    )
  core.HEAPU32.set(words, memory / 4)
  const result = read(memory)
  core._release(memory)
  return result
}

/** The next warp gets a new instance, with a memory of its own. */
function giveUp() {
  core = undefined
}

/**
 * How many bytes the compiler holds inside the wasm. Between two warps it is always the same.
 * @internal
 */
export function memoryInUse(): number {
  return getCore()._memoryInUse()
}
