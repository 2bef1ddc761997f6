// Tests for a warp that mirrors all of space, so that the back of each triangle is its outer side.
import type { Uniforms } from '../core/inputs/vertices.js'
import { ResultSet } from '../core/module/result-set.js'
import type { Place } from '../options/place.js'
import { inputsRead } from './analyse-program.js'
import { runInDouble } from './double.js'
import { originsOf, planInputs, releaseOrigins } from './origins.js'
import type { WarpProgram } from './warp-program.js'

const orientation = new ResultSet([0])

export function isMirrored(
  warp: WarpProgram,
  place: Place,
  uniforms: Uniforms | undefined,
): boolean {
  if (!warp.hasNormals) return false
  const program = warp.orientationProgram()
  const plan = planInputs(warp, program, orientation)
  const origins = originsOf(place, warp, plan, uniforms)
  const numbers = origins.flatMap((origin) => origin.numbers)
  releaseOrigins(plan, origins)
  return runInDouble(program, numbers, 1)[0]! < 0
}

/** Returns the result of `isMirrored` if it is the same for all uniforms; `undefined` if it depends on them. */
export function mirrors(warp: WarpProgram): boolean | undefined {
  if (!warp.hasNormals) return false
  const program = warp.orientationProgram()
  if (inputsRead(program, orientation.numbers).includes(true)) return undefined
  const inputs = program.inputs.flatMap(({ shape }) => Array<number>(shape[0] * shape[1]).fill(0))
  return runInDouble(program, inputs, 1)[0]! < 0
}
