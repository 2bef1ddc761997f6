// glTF files compressed by the encoders of the packages meshoptimizer and draco3dgltf, each with the triangles that it must have.
import draco from 'draco3dgltf'
import { MeshoptEncoder } from 'meshoptimizer'
import { plain } from './gltf-variants.js'
import { trianglesOf } from './shapes.js'
import { GltfWriter, bytesOf, componentTypes, extent, widths } from './writer.js'

await MeshoptEncoder.ready
const encoderModule = await draco.createEncoderModule({})

/**
 * Compresses the views of a writer into its buffer. The document also declares a second buffer, with the uncompressed data. Its file exists
 * only if there is a `fallback`, which is its URI.
 */
class Packer {
  #uncompressed = []

  constructor(writer, extension, fallback) {
    Object.assign(this, { writer, extension, fallback })
    writer.extension(extension, fallback !== undefined)
    const marks = { extensions: { [extension]: { fallback: true } } }
    writer.add('buffers', { byteLength: 0, ...(fallback && { uri: fallback }), ...marks })
  }

  /** Adds a compressed view of `bytes`. With a `filter`, `bytes` are filtered, and `raw` is the same data without the filter. */
  view(bytes, count, byteStride, mode, { filter, raw = bytes } = {}) {
    const version = this.extension === 'KHR_meshopt_compression' ? 1 : 0
    const encoded = MeshoptEncoder.encodeGltfBuffer(bytes, count, byteStride, mode, version)
    const buffer = this.writer.json.buffers[0]
    const byteOffset = buffer.byteLength
    const byteLength = count * byteStride
    buffer.byteLength += Math.ceil(byteLength / 4) * 4
    this.#uncompressed.push([byteOffset, raw])
    return this.writer.add('bufferViews', {
      buffer: 1,
      byteOffset,
      byteLength,
      ...(mode === 'ATTRIBUTES' && { byteStride }),
      extensions: {
        [this.extension]: {
          ...this.writer.bytes(encoded),
          byteStride,
          count,
          mode,
          ...(filter && { filter }),
        },
      },
    })
  }

  accessor(numbers, type, mode = 'ATTRIBUTES', more) {
    const width = widths[type]
    const count = numbers.length / width
    const stride = Math.ceil((width * numbers.BYTES_PER_ELEMENT) / (mode === 'ATTRIBUTES' ? 4 : 1))
    const byteStride = mode === 'ATTRIBUTES' ? 4 * stride : stride
    const padded = new Uint8Array(count * byteStride)
    const size = width * numbers.BYTES_PER_ELEMENT
    for (let i = 0; i < count; i++)
      padded.set(bytesOf(numbers).subarray(i * size, (i + 1) * size), i * byteStride)
    return this.accessorFor(
      this.view(padded, count, byteStride, mode),
      numbers.constructor,
      count,
      type,
      more,
    )
  }

  /** Adds an accessor for a view. */
  accessorFor(bufferView, Type, count, type, more) {
    const componentType = componentTypes.get(Type)
    return this.writer.add('accessors', { bufferView, componentType, count, type, ...more })
  }

  get uncompressedBytes() {
    const bytes = new Uint8Array(this.writer.json.buffers[0].byteLength)
    for (const [byteOffset, data] of this.#uncompressed) bytes.set(data, byteOffset)
    return bytes
  }
}

/** Pads vectors of three numbers to four, as the filters need. */
const padToFour = (numbers) =>
  Float32Array.from({ length: (numbers.length / 3) * 4 }, (_, i) =>
    i % 4 < 3 ? numbers[Math.floor(i / 4) * 3 + (i % 4)] : 0,
  )

/** Returns a function that adds normals with the filter OCTAHEDRAL. */
const octahedral =
  (Type, byteStride, bits) =>
  (packer, { normals }) => {
    const count = normals.length / 3
    const bytes = MeshoptEncoder.encodeFilterOct(padToFour(normals), count, byteStride, bits)
    const view = packer.view(bytes, count, byteStride, 'ATTRIBUTES', { filter: 'OCTAHEDRAL' })
    return packer.accessorFor(view, Type, count, 'VEC3', { normalized: true })
  }

/** Adds positions with the filter EXPONENTIAL. */
const addExponential = (packer, { positions }) => {
  const count = positions.length / 3
  const bytes = MeshoptEncoder.encodeFilterExp(positions, count, 12, 15)
  const view = packer.view(bytes, count, 12, 'ATTRIBUTES', { filter: 'EXPONENTIAL' })
  return packer.accessorFor(view, Float32Array, count, 'VEC3', extent(positions))
}

const addFloats = (packer, { positions }) =>
  packer.accessor(positions, 'VEC3', 'ATTRIBUTES', extent(positions))

/** Makes a meshopt file. `change` modifies the document before it is written, and may return the expected triangles. */
function makePacked(
  {
    extension = 'EXT_meshopt_compression',
    Index = Uint16Array,
    mode = 'TRIANGLES',
    positions = addFloats,
    normals,
    fallback,
    tolerance,
  },
  change = () => {},
) {
  return (shape) => {
    const writer = new GltfWriter()
    const packer = new Packer(writer, extension, fallback)
    const attributes = {
      POSITION: positions(packer, shape),
      NORMAL: (normals ?? ((packer, { normals }) => packer.accessor(normals, 'VEC3')))(
        packer,
        shape,
      ),
      TEXCOORD_0: packer.accessor(shape.uvs, 'VEC2'),
    }
    if (normals) writer.extension('KHR_mesh_quantization')
    const indices = packer.accessor(Index.from(shape.indices), 'SCALAR', mode)
    writer.mesh(attributes, { indices })
    writer.node({ mesh: 0 })
    const triangles = change(packer, shape) ?? trianglesOf(shape)
    const { file } = writer.glb()
    return {
      file,
      triangles,
      tolerance,
      ...(fallback && { files: { [fallback]: packer.uncompressedBytes } }),
    }
  }
}

/** Adds instances whose rotations use the filter QUATERNION. Returns the expected triangles. */
const addRotations = (packer, shape) => {
  const quaternions = Float32Array.from([0, 0, 0, 1, 0, 0, Math.SQRT1_2, Math.SQRT1_2])
  const bytes = MeshoptEncoder.encodeFilterQuat(quaternions, 2, 8, 16)
  const view = packer.view(bytes, 2, 8, 'ATTRIBUTES', { filter: 'QUATERNION' })
  const ROTATION = packer.accessorFor(view, Int16Array, 2, 'VEC4', { normalized: true })
  packer.writer.extension('EXT_mesh_gpu_instancing')
  packer.writer.json.nodes[0].extensions = {
    EXT_mesh_gpu_instancing: { attributes: { ROTATION } },
  }
  return [...trianglesOf(shape), ...trianglesOf(shape, ([x, y, z]) => [-y, x, z])]
}

const addColors = (packer, { positions }) => {
  const count = positions.length / 3
  const colors = new Float32Array(4 * count).fill(0.5)
  const bytes = MeshoptEncoder.encodeFilterColor(colors, count, 4, 8)
  const view = packer.view(bytes, count, 4, 'ATTRIBUTES', { filter: 'COLOR' })
  const { attributes } = packer.writer.json.meshes[0].primitives[0]
  attributes.COLOR_0 = packer.accessorFor(view, Uint8Array, count, 'VEC4', { normalized: true })
}

function encodeDraco({ positions, normals, uvs, indices }, { method, bits }) {
  const count = positions.length / 3
  const encoder = new encoderModule.Encoder()
  const builder = new encoderModule.MeshBuilder()
  const mesh = new encoderModule.Mesh()
  builder.AddFacesToMesh(mesh, indices.length / 3, indices)
  const addAttribute = (type, width, numbers) =>
    builder.AddFloatAttributeToMesh(mesh, encoderModule[type], count, width, numbers)
  const attributes = {
    POSITION: addAttribute('POSITION', 3, positions),
    NORMAL: addAttribute('NORMAL', 3, normals),
    TEXCOORD_0: addAttribute('TEX_COORD', 2, uvs),
  }
  encoder.SetEncodingMethod(encoderModule[method])
  if (bits) encoder.SetAttributeQuantization(encoderModule.POSITION, bits)
  const encoded = new encoderModule.DracoInt8Array()
  const length = encoder.EncodeMeshToDracoBuffer(mesh, encoded)
  const bytes = Uint8Array.from({ length }, (_, i) => encoded.GetValue(i))
  for (const object of [encoded, mesh, builder, encoder]) encoderModule.destroy(object)
  return { bytes, attributes }
}

/** Makes a Draco file. If `isOptional`, its accessors have uncompressed views, too. */
function makeDraco({ isOptional, tolerance = 1e-5, ...encoding }) {
  return (shape) => {
    const { bytes, attributes } = encodeDraco(shape, encoding)
    const { file } = plain(shape, {}, (writer) => {
      writer.extension('KHR_draco_mesh_compression', isOptional)
      const extension = { bufferView: writer.view(bytes), attributes }
      writer.json.meshes[0].primitives[0].extensions = { KHR_draco_mesh_compression: extension }
      if (!isOptional) for (const accessor of writer.json.accessors) delete accessor.bufferView
    }).glb()
    return { file, triangles: trianglesOf(shape), tolerance }
  }
}

export const packedVariants = {
  'meshopt, vertices and triangles': makePacked({}),
  'meshopt, 32-bit indices': makePacked({ Index: Uint32Array }),
  'meshopt, a sequence of indices': makePacked({ mode: 'INDICES' }),
  'meshopt, 8-bit normals': makePacked({ normals: octahedral(Int8Array, 4, 8) }),
  'meshopt, 16-bit normals': makePacked({ normals: octahedral(Int16Array, 8, 12) }),
  'meshopt, exponential positions': makePacked({ positions: addExponential, tolerance: 1e-3 }),
  'meshopt, quaternions': makePacked({ tolerance: 1e-3 }, addRotations),
  'meshopt with a fallback': makePacked({ fallback: 'plain.bin' }),
  'KHR meshopt': makePacked({ extension: 'KHR_meshopt_compression' }),
  'KHR meshopt, colours': makePacked({ extension: 'KHR_meshopt_compression' }, addColors),
  'Draco, edgebreaker encoding': makeDraco({ method: 'MESH_EDGEBREAKER_ENCODING' }),
  'Draco, sequential encoding': makeDraco({ method: 'MESH_SEQUENTIAL_ENCODING' }),
  'Draco with 12 bits': makeDraco({
    method: 'MESH_EDGEBREAKER_ENCODING',
    bits: 12,
    tolerance: 2e-3,
  }),
  'Draco with uncompressed bytes as a fallback': makeDraco({
    method: 'MESH_SEQUENTIAL_ENCODING',
    isOptional: true,
  }),
}
