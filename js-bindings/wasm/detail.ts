// Loads the wasm module that divides meshes for the screen (detail.cpp). It starts with the first mesh that is drawn with detail.
import type { Bound, Detail } from '../generated/detail-bindings.js'
import inlined from '../generated/detail-wasm.js'
import factory from '../generated/detail.js'
import { WasmInstance, explainNoSimd, outOfMemory, type Emscripten } from './instance.js'

export type { Detail }

/** The functions that take the address of a mesh: see detail.cpp. */
interface FrameFunctions {
  _detail_phases(mesh: number): number
  _detail_cut(mesh: number, maxLength: number): number
  _detail_is_coarse(mesh: number, maxLength: number): number
  _detail_forget_samples(mesh: number): void
  _detail_warped(mesh: number): number
  _detail_views(mesh: number, numbers: number): number
  _detail_show(mesh: number, listsSamples: number): number
  _detail_missing_samples(mesh: number): number
  _detail_update(mesh: number, tolerance: number): number
  _detail_stays_exact(mesh: number): number
}

export type DetailModule = Bound & Emscripten & FrameFunctions

export const details = new WasmInstance<DetailModule>({
  factory,
  inlined,
  fail: outOfMemory(
    (megabytes) =>
      `There is not enough memory to draw this mesh with detail: meshes already take ${megabytes} MB.`,
  ),
  explainStart: explainNoSimd('Detail'),
})

/**
 * Returns the number of bytes held in the wasm: none after all meshes were disposed.
 * @internal
 */
export const detailMemoryInUse = (): number => details.get().memoryInUse()
