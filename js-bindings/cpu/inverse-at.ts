// `inverseAt`: where a warp brings a point from.
import { WarpError } from '../errors/errors.js'
import { variationInputs, vertexInputs } from '../core/inputs/inputs.js'
import { ResultSet } from '../core/module/result-set.js'
import { readNumbers } from '../options/numbers.js'
import { checkOptions } from '../options/options.js'
import type { InverseOptions, WarpInverse } from './cpu-warp.js'
import { runInDouble } from './double.js'
import { type Moved, type Triple, inverse } from './inverse.js'
import { originsOf, readingOf } from './origins.js'
import { type WarpProgram, programOf, rejectWithoutNormals } from './warp-program.js'

/** Results of the program of directions: the warped position and the warped direction. */
const positionAndDirection = new ResultSet([0, 1, 2, 3, 4, 5])

const unitVectors: readonly Triple[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

export function inverseAt(
  warp: WarpProgram,
  point: ArrayLike<number>,
  options: InverseOptions = {},
): WarpInverse | undefined {
  checkOptions('inverseAt', options ?? null, ['near', 'normal', 'uv', 'color', 'uniforms'])
  const target = readNumbers('inverseAt: the point', point, 3) as Triple
  const near = readNumbers('inverseAt: near', options.near ?? target, 3) as Triple
  rejectWithoutNormals('inverseAt', warp)
  const program = programOf('inverseAt', warp, warp.directionProgram)
  const reading = readingOf(warp, program, positionAndDirection)
  const origins = originsOf('inverseAt', warp, reading, options.uniforms)
  const shared = origins.map(({ input, isRead, numbers }) => {
    if (!input || !isRead || input === 'position' || input === 'tangent') return numbers
    if (input in variationInputs) return numbers
    const value = options[input as 'normal']
    if (value) return readNumbers(`inverseAt: the ${input}`, value, vertexInputs[input])
    throw new WarpError(
      `inverseAt: the warp reads the ${input} of each vertex, but no "${input}" came.`,
    )
  })
  const given = (place: Triple, direction: Triple) =>
    origins.flatMap(({ input }, i) => {
      if (input === 'position') return place
      return input === 'tangent' ? [...direction, 1] : shared[i]!
    })
  const moved = (place: Triple): Moved => {
    const runs = unitVectors.map((direction) => runInDouble(program, given(place, direction), 6))
    return {
      position: runs[0]!.slice(0, 3) as Triple,
      columns: runs.map((run) => run.slice(3)) as Moved['columns'],
    }
  }
  return inverse(moved, target, near)
}
