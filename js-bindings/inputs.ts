// What an offset function may read, and how many numbers that is.

/** Of each vertex. The offset function does not get the tangent; it is only turned. */
export const vertexInputs = { position: 3, normal: 3, uv: 2, color: 4, tangent: 4 }

/** The same for a whole draw call. */
export const drawInputs = { millis: 1, mouse: 2, size: 2, pixelDensity: 1 }

export const inputSizes = { ...vertexInputs, ...drawInputs }

export type VertexInput = keyof typeof vertexInputs
export type InputName = keyof typeof inputSizes
