// Written by `npm run reference` from the C++: the names of the arrays that are passed to the mesh module, by type, and limits.

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
export type IndexArray = 'indices' | 'originEnds' | 'originTriangles'
export type ByteArray =
  | 'baseColorImage'
  | 'baseColorMimeType'
  | 'normalImage'
  | 'normalMimeType'
  | 'file'
  | 'transfer'
  | 'painted'

export const triangleLimit = 268435456
/** The default of the option `maxTriangles`. */
export const defaultTriangles = 1048576
