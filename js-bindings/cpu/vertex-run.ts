// Evaluates the program of a warp at the vertices of a mesh.
import { variationInputs } from '../core/inputs/inputs.js'
import { arrayNames, type Uniforms, type Vertices } from '../core/inputs/vertices.js'
import type { ResultSet } from '../core/module/result-set.js'
import { noteApproximation } from '../errors/notes.js'
import type { Place } from '../options/place.js'
import type { Sink } from './machine-code.js'
import { originsOf, planInputs, releaseOrigins, type Origin } from './origins.js'
import { copyOverwritten } from './overlaps.js'
import { runProgram } from './run-program.js'
import { missingInput, programOf, type WarpProgram } from './warp-program.js'

/** Computes results of all vertices into sinks. */
export function runOnVertices(
  warp: WarpProgram,
  place: Place,
  mesh: Vertices,
  vertices: number,
  uniforms: Uniforms | undefined,
  results: ResultSet,
  sinks: readonly Sink[],
) {
  const program = programOf(place, warp)
  const plan = planInputs(warp, program, results)
  const origins = originsOf(place, warp, plan, uniforms)
  for (const origin of origins) bindToMesh(warp, place, origin, mesh)
  copyOverwritten(origins, sinks, vertices)
  if (vertices > 0) runProgram(program, results, vertices, origins, sinks)
  releaseOrigins(plan, origins)
}

/** Makes an input that differs by vertex read the array of the mesh. */
function bindToMesh(warp: WarpProgram, place: Place, origin: Origin, mesh: Vertices) {
  const { input, isRead } = origin
  if (!input || !isRead) return
  const values = mesh[arrayNames[input]]
  if (values) {
    origin.values = values
    origin.isUniform = false
    return
  }
  if (input in variationInputs) {
    if (!warp.isAccepted) noteApproximation(place.method, 'surfaceVariation(mesh) of warpjet/mesh')
    return
  }
  throw missingInput(place, input, place.method === 'evaluateAt' ? input : arrayNames[input])
}
