// `bounds`: returns a box that contains the warped positions of all points of a box.
import type { VertexInput } from '../core/inputs/inputs.js'
import { readRanges, uniformsOf, type Box, type Range } from '../core/inputs/vertices.js'
import { Place } from '../options/place.js'
import { boundProgram } from './analyse-program.js'
import type { Bounds, EvaluationOptions } from './cpu-warp.js'
import { originsOf, planInputs } from './origins.js'
import { positionsAlone } from './results.js'
import { programOf, type WarpProgram } from './warp-program.js'

const place = new Place('bounds')

export function bounds(
  warp: WarpProgram,
  box: Box,
  options: EvaluationOptions | undefined,
  budget?: number,
): Bounds {
  const uniforms = uniformsOf(place, options)
  const program = programOf(place, warp)
  const ranges: Partial<Record<VertexInput, Range[]>> = {
    position: readRanges(place.part('box'), box, 3),
    normal: Array<Range>(3).fill([-1, 1]),
    uv: box.uvs ? readRanges(place.part('box.uvs'), box.uvs, 2) : Array<Range>(2).fill([0, 1]),
    color: Array<Range>(4).fill([0, 1]),
  }
  const plan = planInputs(warp, program, positionsAlone)
  const inputRanges = originsOf(place, warp, plan, uniforms).flatMap(
    ({ input, numbers }) =>
      // Inputs that only transform the normal have no range: they do not move the vertex.
      (input && ranges[input]) ?? numbers.map((x): Range => [x, x]),
  )
  const resultRanges = boundProgram(program, inputRanges, positionsAlone.numbers, budget)
  return { min: resultRanges.map(([low]) => low), max: resultRanges.map(([, high]) => high) }
}
