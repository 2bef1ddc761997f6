/**
 * Per-vertex gradients of normal and uv on a shape. An offset that depends on normal or uv needs these gradients for exact normals. p5's
 * own shapes have formulas; on others we compute gradients per triangle, which is exact where the surface is flat.
 */
import { variationNames, type VariationInput } from '../../compile/hosts.js'
import type { Shape } from '../host.js'
import { formulaOf, gradientsByFormula } from './formula-variation.js'
import { gradientsByTriangles } from './triangle-variation.js'

/** For each of `variationNames`, 3 floats per vertex. */
export type Variation = Record<VariationInput, Float32Array>

/** `name` is p5's name of the shape. */
export function variationOf(shape: Shape, name: string): Variation {
  const formula = formulaOf(name)
  const gradients = formula ? gradientsByFormula(shape, formula) : gradientsByTriangles(shape)
  return Object.fromEntries(variationNames.map((each, k) => [each, gradients[k]!])) as Variation
}
