// Written by `npm run reference` from the C++: what has a number there, in the order of its numbers, and what is limited.

/** The arrays of a job of the module of meshes. */
export const floatArrays = {
  positions: 0,
  normals: 1,
  uvs: 2,
  colors: 3,
  tangents: 4,
  normalXGradients: 5,
  normalYGradients: 6,
  normalZGradients: 7,
  uGradients: 8,
  vGradients: 9,
}
export const indexArrays = { indices: 10, ends: 11, triangles: 12 }
export const byteArrays = {
  picture: 13,
  mimeType: 14,
  file: 15,
  name: 16,
  contents: 17,
  painted: 18,
}

export type FloatArray = keyof typeof floatArrays
export type IndexArray = keyof typeof indexArrays
export type ByteArray = keyof typeof byteArrays

export const mostTriangles = 268435456
/** Unless another limit is given. */
export const usualTriangles = 1048576
