/** The arrays of a job of the mesh module, by number; js-bindings/mesh.cpp has them too. */
export const floatArrays = {
  positions: 0,
  normals: 1,
  uvs: 2,
  colors: 3,
  tangents: 4,
  normalXGradients: 11,
  normalYGradients: 12,
  normalZGradients: 13,
  uGradients: 14,
  vGradients: 15,
}
export const indexArray = 5
export const byteArrays = { picture: 6, mimeType: 7, file: 8, name: 9, contents: 10 }

export type FloatArray = keyof typeof floatArrays
export type ByteArray = keyof typeof byteArrays
