// Reads geometries of three.js as flat arrays. They are recognized by their properties, since three.js is not a dependency.

/** The used members of a BufferAttribute or an InterleavedBufferAttribute. */
export interface Attribute {
  count: number
  itemSize: number
  normalized: boolean
  array: ArrayLike<number>
  getX(i: number): number
  getY(i: number): number
  getZ(i: number): number
  getW(i: number): number
}

/** The used members of a BufferGeometry. */
export interface Geometry {
  readonly isBufferGeometry: true
  attributes: Record<string, unknown>
  index: { array: ArrayLike<number> } | null
}

export const isGeometry = (value: unknown): value is Geometry =>
  (value as Partial<Geometry> | null | undefined)?.isBufferGeometry === true

/** Maps an array of a mesh → its attribute in three.js, and its count of numbers per vertex. */
export const geometryAttributes = {
  positions: ['position', 3],
  normals: ['normal', 3],
  uvs: ['uv', 2],
  colors: ['color', 4],
  tangents: ['tangent', 4],
} as const

/** Returns the arrays of a geometry: its own arrays, not copies, if they have the right type and size. */
export function arraysOf({ attributes, index }: Geometry) {
  const arrays: Record<string, Float32Array | Uint32Array> = {}
  for (const [name, [attribute, size]] of Object.entries(geometryAttributes)) {
    const found = attributes[attribute] as Attribute | undefined
    // Colours without alpha are opaque.
    if (found) arrays[name] = attributeNumbers(found, size, 1)
  }
  if (index) arrays.indices = Uint32Array.from(index.array)
  return arrays
}

/** Returns the numbers of an attribute as floats, `size` per vertex; components that a smaller attribute lacks are `missing`. */
export function attributeNumbers(attribute: Attribute, size: number, missing = 0): Float32Array {
  const { count, itemSize } = attribute
  if (isPlain(attribute, size)) return attribute.array as Float32Array
  const numbers = new Float32Array(count * size).fill(missing)
  const parts = ['getX', 'getY', 'getZ', 'getW'] as const
  for (let k = 0; k < Math.min(size, itemSize); k++) {
    const part = parts[k]!
    for (let i = 0; i < count; i++) numbers[i * size + k] = attribute[part](i)
  }
  return numbers
}

const isPlain = (attribute: Attribute, size: number) =>
  !('data' in attribute) &&
  attribute.array instanceof Float32Array &&
  attribute.itemSize === size &&
  attribute.array.length === size * attribute.count
