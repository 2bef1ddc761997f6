// Computes the texels of a normal map.
import { arrayNames, type Uniforms, type Vertices } from '../../core/inputs/vertices.js'
import type { Place } from '../../options/place.js'
import { evaluateFor, type Evaluates } from '../evaluates.js'
import { TangentFrames, normalizeVectors, type FrameKind } from './frames.js'
import type { Surface } from './surface.js'
import { barycentric, type UvTriangles } from './uv-triangles.js'

interface Painting {
  place: Place
  surface: Surface
  triangles: UvTriangles
  /** The triangle of each texel; -1 for none. */
  owners: Int32Array
  warp: Evaluates
  uniforms: Uniforms | undefined
  frames: FrameKind
}

/** The max number of texels that are evaluated together. */
const batchSize = 1 << 16

interface Batch {
  texels: Uint32Array
  /** The three vertices of each texel's triangle. */
  vertices: Uint32Array
  /** The barycentric coordinates of each texel's centre in this triangle. */
  weights: Float64Array
}

/**
 * Returns 3 bytes per texel, which encode the warped normal at the texel's centre in the tangent frame of the warped mesh; they are 0
 * without a triangle. Sets `owners` to -1 for texels where the warp is not finite, if their centre is outside of the triangle.
 */
export function paintNormals({
  place,
  surface,
  triangles,
  owners,
  warp,
  uniforms,
  frames: kind,
}: Painting): Uint8Array {
  const colors = new Uint8Array(3 * owners.length)
  const frames = new TangentFrames(surface.warped, kind)
  for (const { texels, vertices, weights } of batchesOf(triangles, owners)) {
    const rest = interpolate(surface.rest, vertices, weights)
    const { positions, normals } = evaluateFor(place, warp, rest, uniforms) as Inputs
    for (let i = 0; i < texels.length; i++) {
      const texel = texels[i]!
      if (isFiniteVector(positions, 3 * i) && isFiniteVector(normals, 3 * i)) {
        frames.moveTo(vertices, weights, 3 * i)
        frames.encode(normals, 3 * i, colors, 3 * texel)
      } else if (isInside(weights, 3 * i)) throw nonFiniteError(place, rest.positions, i)
      // The warp need not be defined outside of the triangle.
      else owners[texel] = -1
    }
  }
  return colors
}

const isFiniteVector = (vectors: Float32Array, first: number) =>
  Number.isFinite(vectors[first]! + vectors[first + 1]! + vectors[first + 2]!)

const isInside = (weights: Float64Array, first: number) =>
  Math.min(weights[first]!, weights[first + 1]!, weights[first + 2]!) >= 0

function* batchesOf(triangles: UvTriangles, owners: Int32Array): Generator<Batch> {
  const { size } = triangles
  const texels = new Uint32Array(batchSize)
  const vertices = new Uint32Array(3 * batchSize)
  const weights = new Float64Array(3 * batchSize)
  const forms = new Float64Array(9)
  let count = 0
  /** The triangle whose forms are in `forms`. */
  let currentTriangle = -1
  for (let texel = 0; texel < owners.length; texel++) {
    const owner = owners[texel]!
    if (owner < 0) continue
    if (owner !== currentTriangle) triangles.findBarycentricForms(owner, forms)
    currentTriangle = owner
    const x = triangles.nearestRepetition(owner, texel % size, 0)
    const y = triangles.nearestRepetition(owner, Math.floor(texel / size), 1)
    texels[count] = texel
    let sum = 0
    for (let k = 0; k < 3; k++) {
      vertices[3 * count + k] = triangles.indices[3 * owner + k]!
      sum += weights[3 * count + k] = limitExtrapolation(barycentric(forms, k, x, y))
    }
    for (let k = 0; k < 3; k++) weights[3 * count + k]! /= sum
    if (++count < batchSize) continue
    yield { texels, vertices, weights }
    count = 0
  }
  if (count)
    yield {
      texels: texels.subarray(0, count),
      vertices: vertices.subarray(0, 3 * count),
      weights: weights.subarray(0, 3 * count),
    }
}

/** Limits how far texels outside of a triangle extrapolate from it: from a narrow triangle, a texel can be many times its width away. */
const limitExtrapolation = (weight: number) => Math.min(Math.max(weight, -0.5), 1.5)

type Inputs = Vertices & Record<'positions' | 'normals', Float32Array>

/** Interpolates all inputs of the warp between the three vertices of each point. Scales normals to length 1. */
function interpolate(rest: Surface['rest'], vertices: Uint32Array, weights: Float64Array): Inputs {
  const inputs: Partial<Record<keyof Vertices, Float32Array>> = {}
  for (const name of Object.values(arrayNames)) {
    const numbers = rest[name]
    if (!numbers || name === 'tangents') continue
    const size = (3 * numbers.length) / rest.positions.length
    const results = new Float32Array((size * vertices.length) / 3)
    for (let i = 0; i < vertices.length; i++) {
      const [source, target] = [size * vertices[i]!, size * Math.floor(i / 3)]
      for (let k = 0; k < size; k++) results[target + k]! += weights[i]! * numbers[source + k]!
    }
    inputs[name] = results
  }
  normalizeVectors(inputs.normals!)
  return inputs as Inputs
}

function nonFiniteError(place: Place, positions: Float32Array, i: number) {
  const position = [...positions.subarray(3 * i, 3 * i + 3)].join(', ')
  return place.error(
    `the warp has no finite position and normal between vertices, at (${position}); check whether it divides by 0 at this position, for example.`,
  )
}
