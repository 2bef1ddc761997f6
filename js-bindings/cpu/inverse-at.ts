// `inverseAt`: finds a position that a warp moves to a point.
import { variationInputs, vertexInputs } from '../core/inputs/inputs.js'
import { ResultSet } from '../core/module/result-set.js'
import { readNumbers } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { rejectUnknownOptions } from '../options/schema.js'
import type { InverseOptions, WarpInverse } from './cpu-warp.js'
import { runInDouble } from './double.js'
import { findInverse, type Triple, type Warped } from './inverse.js'
import { originsOf, planInputs } from './origins.js'
import { missingInput, programOf, rejectWithoutNormals, type WarpProgram } from './warp-program.js'

const place = new Place('inverseAt')
const inverseOptions = ['near', 'normal', 'uv', 'color', 'uniforms']

/** Results of `directionProgram`: the warped position and the warped direction. */
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
  rejectUnknownOptions(options ?? null, inverseOptions, place)
  const target = readNumbers(place.part('the point'), point, 3) as Triple
  const near = readNumbers(place.part('near'), options.near ?? target, 3) as Triple
  rejectWithoutNormals(place, warp)
  const program = programOf(place, warp, warp.directionProgram)
  const plan = planInputs(warp, program, positionAndDirection)
  const origins = originsOf(place, warp, plan, options.uniforms)
  const shared = origins.map(({ input, isRead, numbers }) => {
    if (!input || !isRead || input === 'position' || input === 'tangent') return numbers
    if (input in variationInputs) return numbers
    const value = options[input as 'normal']
    if (value) return readNumbers(place.part(`the ${input}`), value, vertexInputs[input])
    throw missingInput(place, input, input)
  })
  const inputNumbers = (position: Triple, direction: Triple) =>
    origins.flatMap(({ input }, i) => {
      if (input === 'position') return position
      return input === 'tangent' ? [...direction, 1] : shared[i]!
    })
  const warpAt = (position: Triple): Warped => {
    const runs = unitVectors.map((direction) =>
      runInDouble(program, inputNumbers(position, direction), 6),
    )
    return {
      position: runs[0]!.slice(0, 3) as Triple,
      columns: runs.map((run) => run.slice(3)) as Warped['columns'],
    }
  }
  return findInverse(warpAt, target, near)
}
