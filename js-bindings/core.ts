// Loads the compiler. Nothing happens before the first warp.
import { startCore } from './core-module.js'

/** A compilation inside the wasm: an address, to be closed. */
export type Session = number & { readonly session: unique symbol }

/**
 * js-bindings/bindings.cpp. Handles stand for values, numbers, vectors and matrices alike; `failed` stands in the place
 * of one that there cannot be, and then `problem` says why.
 */
export interface Core {
  _constant(session: Session, value: number): number
  _push(session: Session, handle: number): void
  _call(session: Session, operation: number, isMethod: boolean): number
  _callFunction(session: Session, hostFunction: number): number
  _callNoise(
    session: Session,
    kind: number,
    base: number,
    octaves: number,
    isMethod: boolean,
  ): number
  _callTexture(session: Session, filter: number, wrap: number): number
  _swizzle(session: Session, handle: number, count: number, indices: number): number
  _pendingCount(session: Session): number
  _pendingCall(session: Session, place: number): number
  _functionOfCall(session: Session, call: number): number
  _argumentOfCall(session: Session, call: number, i: number): number
  _setPartials(session: Session, call: number): number
  _dependsOn(session: Session, handle: number, input: number): number
  _shapeOf(session: Session, handle: number): number
  _nodeCount(session: Session): number
  _operationCount(session: Session): number
  _temporaryCount(session: Session): number
  _makeProgram(session: Session): number
  _programWords(session: Session): number
  _programSize(session: Session): number
  _instructionCount(session: Session): number
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
  _closeSession(session: Session): void
  _memoryInUse(): number

  operationNames(): string
  open(target: string): Session | 0
  problem(session: Session): string
  input(session: Session, method: string, label: string, columns: number, rows: number): number
  addFunction(session: Session, name: string, source: string, arity: number): number
  comment(session: Session, text: string): void
  output(session: Session, method: string, name: string, handle: number): boolean
  outputSum(
    session: Session,
    method: string,
    name: string,
    handle: number,
    input: number,
    term: number,
  ): boolean
  build(session: Session, maxDepth: number): boolean
  code(session: Session): string
  declarations(session: Session): string
  inputLines(session: Session): string
  allInputLines(session: Session): string
  outputLines(session: Session): string

  /** Whether it ran out of memory, and nothing of it may be used any more. */
  isBroken?: boolean

  readonly HEAPU32: Uint32Array
  readonly HEAPF64: Float64Array
}

export const failed = -1
export const needsPartials = -2

let core: Core | undefined

export function getCore(): Core {
  return (core ??= startCore<Core>(giveUp))
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
