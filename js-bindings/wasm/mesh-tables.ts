// Written by `npm run reference` from the C++: the arrays of a mesh's job by what they hold, and limits.

export type FloatArray =
  | 'positions'
  | 'normals'
  | 'uvs'
  | 'colors'
  | 'tangents'
  | 'normalXGradients'
  | 'normalYGradients'
  | 'normalZGradients'
  | 'uGradients'
  | 'vGradients'
export type IndexArray = 'indices' | 'ends' | 'triangles'
export type ByteArray = 'picture' | 'mimeType' | 'file' | 'contents' | 'painted'

export const mostTriangles = 268435456
/** Unless another limit is given. */
export const usualTriangles = 1048576
