/**
 * How normal and uv vary over a shape, by vertex: what turns the light of an offset that depends on them. p5's own shapes have
 * formulas; others are taken triangle by triangle, which is exact where they are flat.
 */
import { type VariationInput, variationNames } from '../../core/inputs/inputs.js'
import { byFormula, formulaOf } from './formula-variation.js'
import type { Shape } from '../host.js'
import { byTriangles } from './triangle-variation.js'

/** By vertex, three numbers for each of `variationNames`. */
export type Variation = Record<VariationInput, Float32Array>

/** `name` is p5's. */
export function variationOf(shape: Shape, name: string): Variation {
  const formula = formulaOf(name)
  const gradients = formula ? byFormula(shape, formula) : byTriangles(shape)
  return Object.fromEntries(variationNames.map((each, k) => [each, gradients[k]!])) as Variation
}
