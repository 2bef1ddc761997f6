// `foldover`: where a warp turns the surface inside out.
import { type Vertices, checkVertices, uniformsOf } from '../core/inputs/vertices.js'
import type { EvaluationOptions, Foldover } from './cpu-warp.js'
import { determinantAlone, numbersOf } from './results.js'
import { runOnVertices } from './vertex-run.js'
import { type WarpProgram, rejectWithoutNormals } from './warp-program.js'

export function foldover(
  warp: WarpProgram,
  mesh: Vertices,
  options: EvaluationOptions | undefined,
): Foldover {
  const uniforms = uniformsOf('foldover', options)
  rejectWithoutNormals('foldover', warp)
  const vertices = checkVertices('foldover', mesh)
  const values = new Float32Array(vertices)
  const sinks = [{ values, results: numbersOf.determinant }]
  runOnVertices(warp, 'foldover', mesh, vertices, uniforms, determinantAlone, sinks)
  const mask = Uint8Array.from(values, (value) => Number(!(value > 0)))
  return { mask, count: mask.reduce((sum, folded) => sum + folded, 0) }
}
