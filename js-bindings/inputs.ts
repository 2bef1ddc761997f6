// What an offset function may read, and how many numbers that is.

/**
 * How normal and uv vary over the surface, which decides the turn of an offset that depends on them: of the derivative of the
 * normal, a symmetric matrix (the shape operator), the diagonal xx, yy, zz, and yz, xz, xy; the gradients of u and v.
 */
export const variationInputs = {
  shapeDiagonal: 3,
  shapeOffDiagonal: 3,
  uGradient: 3,
  vGradient: 3,
} as const

export type VariationInput = keyof typeof variationInputs
export const variationNames = Object.keys(variationInputs) as VariationInput[]

/** The attributes of p5 shapes that carry them. */
export const variationAttributes = variationNames.map((name) => [name, `aWarpjet_${name}`] as const)

/** Of each vertex. The offset function does not get the tangent, which is only turned, nor how the surface varies. */
export const vertexInputs = {
  position: 3,
  normal: 3,
  uv: 2,
  color: 4,
  tangent: 4,
  ...variationInputs,
}

/** The same for a whole draw call. */
export const drawInputs = { millis: 1, mouse: 2, size: 2, pixelDensity: 1 }

export const inputSizes = { ...vertexInputs, ...drawInputs }

export type VertexInput = keyof typeof vertexInputs
export type InputName = keyof typeof inputSizes
