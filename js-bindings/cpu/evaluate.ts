// `evaluate` and `evaluateAt`: warp vertices.
import { vertexInputs, type VertexInput } from '../core/inputs/inputs.js'
import { arrayNames, countVertices, uniformsOf, type Vertices } from '../core/inputs/vertices.js'
import { readNumbers } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { rejectUnknownOptions } from '../options/schema.js'
import type { EvaluateOptions, PointInputs, WarpedPoint } from './cpu-warp.js'
import {
  releaseSinks,
  takeSinks,
  vertexResults,
  type VertexResults,
  type WarpedVertices,
} from './results.js'
import { runOnVertices } from './vertex-run.js'
import type { WarpProgram } from './warp-program.js'

const place = new Place('evaluate')
const pointPlace = new Place('evaluateAt')
const outPlace = place.part('out')

const pointOptions = [
  ...Object.keys(vertexInputs).filter((name) => name !== 'position'),
  'uniforms',
]

const evaluateOptions = ['uniforms', 'out']

export function evaluate(
  warp: WarpProgram,
  mesh: Vertices,
  options: EvaluateOptions | undefined,
): WarpedVertices {
  const uniforms = uniformsOf(place, options, evaluateOptions)
  const out = options?.out
  rejectUnknownOptions(out, vertexResults.frame.names, outPlace)
  const vertices = countVertices(place, mesh)
  const results = resultsFor(warp, mesh)
  const sinks = takeSinks(results, vertices, out)
  runOnVertices(warp, place, mesh, vertices, uniforms, results, sinks)
  return releaseSinks(results, sinks, out)
}

export function evaluateAt(
  warp: WarpProgram,
  position: ArrayLike<number>,
  inputs: PointInputs = {},
): WarpedPoint {
  rejectUnknownOptions(inputs ?? null, pointOptions, pointPlace)
  const vertex: Vertices = { positions: readNumbers(pointPlace.part('the position'), position, 3) }
  for (const key of Object.keys(inputs)) {
    const name = key as VertexInput
    const value = inputs[key as 'normal']
    if (key === 'uniforms' || value === undefined) continue
    vertex[arrayNames[name]] = readNumbers(pointPlace.part(`the ${key}`), value, vertexInputs[name])
  }
  const results = resultsFor(warp, vertex)
  const { point } = results
  runOnVertices(warp, pointPlace, vertex, 1, inputs.uniforms, results, point)
  const [positions, normals, tangents] = point
  return {
    position: Array.from(positions!.values),
    ...(normals && { normal: Array.from(normals.values) }),
    ...(tangents && { tangent: Array.from(tangents.values) }),
  }
}

function resultsFor({ hasNormals }: WarpProgram, mesh: Vertices): VertexResults {
  if (!hasNormals || !mesh.normals) return vertexResults.position
  return mesh.tangents ? vertexResults.frame : vertexResults.surface
}
