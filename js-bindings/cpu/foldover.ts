// `foldover`: finds vertices where a warp turns the surface inside out.
import { countVertices, uniformsOf, type Vertices } from '../core/inputs/vertices.js'
import { Place } from '../options/place.js'
import type { EvaluationOptions, Foldover } from './cpu-warp.js'
import { determinantAlone, resultNumbers } from './results.js'
import { runOnVertices } from './vertex-run.js'
import { rejectWithoutNormals, type WarpProgram } from './warp-program.js'

const place = new Place('foldover')

export function foldover(
  warp: WarpProgram,
  mesh: Vertices,
  options: EvaluationOptions | undefined,
): Foldover {
  const uniforms = uniformsOf(place, options)
  rejectWithoutNormals(place, warp)
  const vertices = countVertices(place, mesh)
  const values = new Float32Array(vertices)
  const sinks = [{ values, results: resultNumbers.determinant }]
  runOnVertices(warp, place, mesh, vertices, uniforms, determinantAlone, sinks)
  const mask = Uint8Array.from(values, (value) => Number(!(value > 0)))
  return { mask, count: mask.reduce((sum, isFolded) => sum + isFolded, 0) }
}
