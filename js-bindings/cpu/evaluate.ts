// `evaluate` and `evaluateAt`: where a warp moves vertices.
import { type VertexInput, vertexInputs } from '../core/inputs/inputs.js'
import { type Vertices, arrayNames, checkVertices, uniformsOf } from '../core/inputs/vertices.js'
import { readNumbers } from '../options/numbers.js'
import { checkOptions } from '../options/options.js'
import type { EvaluateOptions, PointInputs, WarpedPoint } from './cpu-warp.js'
import { type Wanted, type WarpedVertices, leaveSinks, takeSinks, wanted } from './results.js'
import { runOnVertices } from './vertex-run.js'
import type { WarpProgram } from './warp-program.js'

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
  const uniforms = uniformsOf('evaluate', options, evaluateOptions)
  const out = options?.out
  checkOptions('evaluate: out', out, wanted.frame.names)
  const vertices = checkVertices('evaluate', mesh)
  const results = wantedOf(warp, mesh)
  const sinks = takeSinks(results, vertices, out)
  runOnVertices(warp, 'evaluate', mesh, vertices, uniforms, results, sinks)
  return leaveSinks(results, sinks, out)
}

export function evaluateAt(
  warp: WarpProgram,
  position: ArrayLike<number>,
  inputs: PointInputs = {},
): WarpedPoint {
  checkOptions('evaluateAt', inputs ?? null, pointOptions)
  const vertex: Vertices = { positions: readNumbers('evaluateAt: the position', position, 3) }
  for (const key of Object.keys(inputs)) {
    const name = key as VertexInput
    const value = inputs[key as 'normal']
    if (key === 'uniforms' || value === undefined) continue
    vertex[arrayNames[name]] = readNumbers(`evaluateAt: the ${key}`, value, vertexInputs[name])
  }
  const results = wantedOf(warp, vertex)
  const { point } = results
  runOnVertices(warp, 'evaluateAt', vertex, 1, inputs.uniforms, results, point)
  const [positions, normals, tangents] = point
  return {
    position: Array.from(positions!.values),
    ...(normals && { normal: Array.from(normals.values) }),
    ...(tangents && { tangent: Array.from(tangents.values) }),
  }
}

function wantedOf({ hasNormals }: WarpProgram, mesh: Vertices): Wanted {
  if (!hasNormals || !mesh.normals) return wanted.place
  return mesh.tangents ? wanted.frame : wanted.surface
}
