// Runs the program of a warp on the vertices of a mesh.
import { WarpError } from '../errors/errors.js'
import { noteApproximation } from '../errors/notes.js'
import { variationInputs, vertexInputs } from '../core/inputs/inputs.js'
import { type Uniforms, type Vertices, arrayNames } from '../core/inputs/vertices.js'
import type { ResultSet } from '../core/module/result-set.js'
import type { Sink } from './machine-code.js'
import { runProgram } from './run-program.js'
import { type Origin, keep, originsOf, readingOf } from './origins.js'
import { copyOverwritten } from './overlaps.js'
import { type WarpProgram, programOf } from './warp-program.js'

/** Puts the results that are wanted into sinks. */
export function runOnVertices(
  warp: WarpProgram,
  method: string,
  mesh: Vertices,
  vertices: number,
  uniforms: Uniforms | undefined,
  results: ResultSet,
  sinks: readonly Sink[],
) {
  const program = programOf(method, warp)
  const reading = readingOf(warp, program, results)
  const origins = originsOf(method, warp, reading, uniforms)
  for (const origin of origins) takeVertices(warp, method, origin, mesh)
  copyOverwritten(origins, sinks, vertices)
  if (vertices > 0) runProgram(program, results, vertices, origins, sinks)
  keep(reading, origins)
}

function takeVertices(warp: WarpProgram, method: string, origin: Origin, mesh: Vertices) {
  const { input, isRead } = origin
  if (!input || !isRead) return
  const values = mesh[arrayNames[input]]
  if (values) {
    origin.values = values
    origin.size = vertexInputs[input]
    origin.isUniform = false
    return
  }
  if (input in variationInputs) {
    if (!warp.isAccepted) noteApproximation(method, 'surfaceVariation(mesh) of warpjet/mesh')
    return
  }
  const name = method === 'evaluateAt' ? input : arrayNames[input]
  throw new WarpError(
    `${method}: the warp reads the ${input} of each vertex, but no "${name}" came.`,
  )
}
