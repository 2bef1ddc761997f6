// What an offset function may read, and how many numbers that is.

/**
 * The gradients over the surface of x, y and z of the normal and of u and v, in this order: how these vary decides the turn of
 * an offset that depends on them.
 */
export const variationInputs = {
  normalXGradient: 3,
  normalYGradient: 3,
  normalZGradient: 3,
  uGradient: 3,
  vGradient: 3,
} as const

export type VariationInput = keyof typeof variationInputs
export const variationNames = Object.keys(variationInputs) as VariationInput[]

/** The attribute of a p5 shape that carries one. */
export const variationAttribute = (name: string) => `aWarpjet_${name}`

/** Where `uniforms` of an offset function takes the name of one that a text reads as whole numbers. */
export const markWhole = Symbol.for('warpjet.whole')

/** Of each vertex. The offset function does not get the tangent, which is only turned, nor how the surface varies. */
export const vertexInputs = {
  position: 3,
  normal: 3,
  uv: 2,
  color: 4,
  tangent: 4,
  ...variationInputs,
}

/** The same for a whole draw call, or for all of one instance. */
export const drawInputs = { millis: 1, mouse: 2, size: 2, pixelDensity: 1, instance: 1 }

export const inputSizes = { ...vertexInputs, ...drawInputs }

export type VertexInput = keyof typeof vertexInputs
export type InputName = keyof typeof inputSizes
