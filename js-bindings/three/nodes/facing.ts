// Replaces vectors that are zero at a pixel.
import { BackSide, DoubleSide } from 'three'
import type { Builder } from './builder.js'
import { tsl, type AnyNode } from './tsl.js'

/** Returns the vector with length 1, or `other` if the vector is zero or not finite. */
export const normalizeOr = (vector: AnyNode, other: AnyNode) =>
  tsl.select(vector.dot(vector).greaterThan(0), vector.normalize(), other)

/** Negates the vector where three.js later negates the normals of back faces. */
export function onBack({ material: { side } }: Builder, vector: AnyNode): AnyNode {
  if (side === BackSide) return vector.negate()
  return side === DoubleSide ? vector.mul(tsl.faceDirection) : vector
}
