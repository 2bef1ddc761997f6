// `bounds`: a box around all that a warp makes of a box.
import type { VertexInput } from '../core/inputs/inputs.js'
import { type Box, type Range, readRanges, uniformsOf } from '../core/inputs/vertices.js'
import { boundProgram } from './analyse-program.js'
import type { Bounds, EvaluationOptions } from './cpu-warp.js'
import { originsOf, readingOf } from './origins.js'
import { positionsAlone } from './results.js'
import { type WarpProgram, programOf } from './warp-program.js'

export function bounds(
  warp: WarpProgram,
  box: Box,
  options: EvaluationOptions | undefined,
): Bounds {
  const uniforms = uniformsOf('bounds', options)
  const program = programOf('bounds', warp)
  const ranges: Partial<Record<VertexInput, Range[]>> = {
    position: readRanges('bounds', 'box', box, 3),
    normal: Array<Range>(3).fill([-1, 1]),
    uv: box.uvs ? readRanges('bounds', 'box.uvs', box.uvs, 2) : Array<Range>(2).fill([0, 1]),
    color: Array<Range>(4).fill([0, 1]),
  }
  const reading = readingOf(warp, program, positionsAlone)
  const given = originsOf('bounds', warp, reading, uniforms).flatMap(
    ({ input, numbers }) =>
      // Inputs that only transform the normal do not move the vertex.
      (input && ranges[input]) ?? numbers.map((x): Range => [x, x]),
  )
  const found = boundProgram(program, given, positionsAlone.numbers)
  return { min: found.map(([low]) => low), max: found.map(([, high]) => high) }
}
