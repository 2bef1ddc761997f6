// Tests for a warp that mirrors all of space, so that the outer side of each triangle is its back.
import type { Uniforms } from '../core/inputs/vertices.js'
import { ResultSet } from '../core/module/result-set.js'
import { inputsRead } from './analyse-program.js'
import { runInDouble } from './double.js'
import { keep, originsOf, readingOf } from './origins.js'
import type { WarpProgram } from './warp-program.js'

const orientation = new ResultSet([0])

export function isMirrored(
  warp: WarpProgram,
  method: string,
  uniforms: Uniforms | undefined,
): boolean {
  if (!warp.hasNormals) return false
  const program = warp.orientationProgram()
  const reading = readingOf(warp, program, orientation)
  const origins = originsOf(method, warp, reading, uniforms)
  const numbers = origins.flatMap((origin) => origin.numbers)
  keep(reading, origins)
  return runInDouble(program, numbers, 1)[0]! < 0
}

/** `undefined` if uniforms decide it. */
export function mirrors(warp: WarpProgram): boolean | undefined {
  if (!warp.hasNormals) return false
  const program = warp.orientationProgram()
  if (inputsRead(program, orientation.numbers).includes(true)) return undefined
  const inputs = program.inputs.flatMap(({ shape }) => Array<number>(shape[0] * shape[1]).fill(0))
  return runInDouble(program, inputs, 1)[0]! < 0
}
