// Loads the compiler. The wasm is inlined and compiled synchronously, so that `createWarp` works in
// a plain `setup()`; nothing happens before the first warp.
import { inflateSync } from 'fflate'
import instantiate from './generated/core.js'
import base64 from './generated/core-wasm.js'

/** A compilation inside the wasm: an address, to be closed. */
export type Session = number & { readonly session: unique symbol }

export interface EmittedOutput {
  name: string
  ids: readonly number[]
  /** The output as a sum of an input and an earlier output, for shorter text. */
  sum?: { input: number; output: number }
}

export interface Emitted {
  /** Missing where there is a problem: `notFinite` or `graphFull`. */
  code?: string
  problem?: number
  inputs: number[]
  nodes: number
  operations: number
  temporaries: number
}

/** js-bindings/bindings.cpp. Ids are non-negative; `notFinite` and `graphFull` stand in their place. */
export interface Core {
  _constant(session: Session, value: number): number
  _component(session: Session, input: number, component: number): number
  _apply(session: Session, op: number, a: number, b: number, c: number): number
  _derivative(session: Session, root: number, input: number): number
  _closeSession(session: Session): void

  operations(): { name: string; arity: number }[]
  open(target: string): Session | 0
  input(session: Session, expression: string, size: number): number
  inputProblem(session: Session, expression: string): string
  outputProblem(session: Session, name: string): string
  warpedPosition(session: Session, position: readonly number[], offset: readonly number[]): number[]
  warpedNormal(
    session: Session,
    position: readonly number[],
    normal: readonly number[],
    offset: readonly number[],
  ): number[]
  emit(
    session: Session,
    outputs: EmittedOutput[],
    maxDepth: number,
    comments: [number, string][],
  ): Emitted
  _memoryInUse(): number
}

export const notFinite = -1
export const graphFull = -2

let core: Core | undefined

export function getCore(): Core {
  return (core ??= instantiate<Core>({ wasmBinary: inflateSync(decode(base64)) }))
}

/** How many bytes the compiler holds inside the wasm. Between two warps it is always the same. */
export function memoryInUse(): number {
  return getCore()._memoryInUse()
}

function decode(text: string): Uint8Array {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
}
