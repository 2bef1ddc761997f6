// The inputs of an offset function, with their counts of numbers.

/**
 * The gradients over the surface of the normal's x, y and z and of u and v, in this order. If an offset depends on normal or uv, the
 * warped normal depends on these gradients.
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

/** Returns the name of the attribute that carries a gradient in the meshes of hosts. */
export const variationAttribute = (name: string) => `aWarpjet_${name}`

/** The key of a method of `uniforms`: it takes the name of a uniform and marks it as one that GLSL source reads as whole numbers. */
export const markWhole = Symbol.for('warpjet.whole')

/** Inputs that differ by vertex. The offset function gets neither the tangent, which is only transformed, nor the gradients. */
export const vertexInputs = {
  position: 3,
  normal: 3,
  uv: 2,
  color: 4,
  tangent: 4,
  ...variationInputs,
}

/** Inputs that are constant in a draw call or, for `instance`, in an instance. */
export const drawInputs = { millis: 1, mouse: 2, size: 2, pixelDensity: 1, instance: 1 }

export const inputSizes = { ...vertexInputs, ...drawInputs }

export type VertexInput = keyof typeof vertexInputs
export type InputName = keyof typeof inputSizes
