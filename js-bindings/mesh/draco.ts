// Decodes a primitive of a glTF by Draco's wasm module, whose C++ objects must be destroyed after use.

/** The attributes of a primitive to decode. `componentType` is glTF's; `width` is the number of components per vertex. */
export interface DracoPlan {
  attributes: { id: number; componentType: number; width: number }[]
}

interface Attribute {
  ptr: number
  num_components(): number
}

interface Geometry {
  num_points(): number
  num_faces(): number
}

interface Status {
  ok(): boolean
  error_msg(): string
}

interface Decoder {
  GetEncodedGeometryType(buffer: object): number
  DecodeBufferToMesh(buffer: object, mesh: Geometry): Status
  GetAttributeByUniqueId(mesh: Geometry, id: number): Attribute
  GetTrianglesUInt32Array(mesh: Geometry, size: number, address: number): boolean
  GetAttributeDataArrayForAllPoints(
    mesh: Geometry,
    attribute: Attribute,
    type: number,
    size: number,
    address: number,
  ): boolean
}

export interface DracoModule {
  Decoder: new () => Decoder
  DecoderBuffer: new () => { Init(bytes: Int8Array, length: number): void }
  Mesh: new () => Geometry
  TRIANGULAR_MESH: number
  HEAPF32: Float32Array
  _malloc(size: number): number
  _free(address: number): void
  destroy(object: object): void
}

/** Maps glTF's number of a component type to Draco's name and the size in bytes. */
const componentTypes: Record<number, [name: string, bytes: number]> = {
  5120: ['DT_INT8', 1],
  5121: ['DT_UINT8', 1],
  5122: ['DT_INT16', 2],
  5123: ['DT_UINT16', 2],
  5125: ['DT_UINT32', 4],
  5126: ['DT_FLOAT32', 4],
}

/** The maximum size of a mesh, as in files.hpp. */
const maxBytes = 2 ** 30

/** Returns the indices, then the values of each attribute. Throws an Error for what it cannot decode. */
export function decodeDraco(
  module: DracoModule,
  { attributes }: DracoPlan,
  bytes: Uint8Array,
): Uint8Array[] {
  const objects: object[] = []
  const make = <Instance extends object>(Class: new () => Instance): Instance => {
    const object = new Class()
    objects.push(object)
    return object
  }
  try {
    const decoder = make(module.Decoder)
    const buffer = make(module.DecoderBuffer)
    buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length)
    if (decoder.GetEncodedGeometryType(buffer) !== module.TRIANGULAR_MESH)
      throw new Error('it is not a triangle mesh')
    const mesh = make(module.Mesh)
    const status = decoder.DecodeBufferToMesh(buffer, mesh)
    if (!status.ok()) throw new Error(status.error_msg())

    const corners = 3 * mesh.num_faces()
    const indices = read(module, 4 * corners, (address) =>
      decoder.GetTrianglesUInt32Array(mesh, 4 * corners, address),
    )
    return [
      indices,
      ...attributes.map(({ id, componentType, width }) => {
        const attribute = decoder.GetAttributeByUniqueId(mesh, id)
        const type = componentTypes[componentType]
        if (!attribute.ptr || !type) throw new Error(`it has no attribute ${id}`)
        if (attribute.num_components() !== width)
          throw new Error(
            `its attribute ${id}: expected ${width} numbers per vertex, got ${attribute.num_components()}`,
          )
        const [name, size] = type
        const length = mesh.num_points() * width * size
        const number = module[name as keyof DracoModule] as unknown as number
        return read(module, length, (address) =>
          decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, number, length, address),
        )
      }),
    ]
  } finally {
    for (const object of objects.reverse()) module.destroy(object)
  }
}

/** Returns a copy of the `length` bytes that `write` writes into the module's memory. */
function read(module: DracoModule, length: number, write: (address: number) => boolean) {
  if (length > maxBytes) throw new Error('it is too large')
  const address = module._malloc(length)
  try {
    if (length && (!address || !write(address))) throw new Error('it has too little data')
    return new Uint8Array(module.HEAPF32.buffer, address, length).slice()
  } finally {
    module._free(address)
  }
}
