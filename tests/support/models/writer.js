// Writes glTF files for tests according to the glTF 2.0 specification, without using the library.
import { writeGlb } from '../glb.js'

export const componentTypes = new Map([
  [Int8Array, 5120],
  [Uint8Array, 5121],
  [Int16Array, 5122],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
  [Float32Array, 5126],
])
export const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 }

export const bytesOf = ({ buffer, byteOffset, byteLength }) =>
  new Uint8Array(buffer, byteOffset, byteLength)

export class GltfWriter {
  json = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [] }
  #parts = []
  #length = 0

  /** Appends an element to an array of the document; returns its index. */
  add(list, element) {
    this.json[list] ??= []
    return this.json[list].push(element) - 1
  }

  /** Marks an extension as used, and as required unless `isOptional`. */
  extension(name, isOptional = false) {
    for (const list of ['extensionsUsed', ...(isOptional ? [] : ['extensionsRequired'])]) {
      this.json[list] ??= []
      if (!this.json[list].includes(name)) this.json[list].push(name)
    }
  }

  /** Appends bytes to the buffer; returns the members by which a view refers to them. */
  bytes(bytes) {
    const byteOffset = this.#length
    const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4)
    padded.set(bytes)
    this.#parts.push(padded)
    this.#length += padded.length
    return { buffer: 0, byteOffset, byteLength: bytes.length }
  }

  /** Adds a view of a typed array; returns its index. */
  view(array, more) {
    return this.add('bufferViews', { ...this.bytes(bytesOf(array)), ...more })
  }

  /** Adds an accessor for a typed array, with further members `more`. With `more.isMorph`, it declares no bounds. */
  accessor(numbers, type, more = {}) {
    const count = numbers.length / widths[type]
    const componentType = componentTypes.get(numbers.constructor)
    return this.add('accessors', {
      bufferView: this.view(numbers),
      componentType,
      count,
      type,
      ...(type === 'VEC3' && componentType === 5126 && !more.isMorph && extent(numbers)),
      ...Object.fromEntries(Object.entries(more).filter(([name]) => name !== 'isMorph')),
    })
  }

  /** Adds a mesh of one primitive. `more` are further members of the primitive, `meshMembers` of the mesh. */
  mesh(attributes, more, meshMembers) {
    return this.add('meshes', { primitives: [{ attributes, ...more }], ...meshMembers })
  }

  /** Adds a node of the scene. */
  node(node) {
    const index = this.add('nodes', node)
    this.json.scenes[0].nodes.push(index)
    return index
  }

  get binary() {
    const bytes = new Uint8Array(this.#length)
    let byteOffset = 0
    for (const part of this.#parts) {
      bytes.set(part, byteOffset)
      byteOffset += part.length
    }
    return bytes
  }

  #document(uri) {
    const { buffers = [], ...json } = this.json
    const buffer = { byteLength: this.#length, ...(uri && { uri }) }
    return { ...json, ...(this.#length && { buffers: [buffer, ...buffers] }) }
  }

  /** Writes a GLB file. */
  glb() {
    return { file: writeGlb(this.#document(), this.binary) }
  }

  /** Writes a .gltf file whose buffer is a data URI. */
  embedded() {
    const text = Buffer.from(this.binary).toString('base64')
    return { file: this.#text(`data:application/octet-stream;base64,${text}`) }
  }

  /** Writes a .gltf file and the file of its buffer. */
  external() {
    return { file: this.#text('mesh%20data.bin'), files: { 'mesh%20data.bin': this.binary } }
  }

  #text(uri) {
    return new TextEncoder().encode(JSON.stringify(this.#document(uri)))
  }
}

/** Returns the bounds that an accessor declares for vectors of three numbers. */
export function extent(numbers) {
  const [min, max] = [Array(3).fill(Infinity), Array(3).fill(-Infinity)]
  numbers.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3], value)
    max[i % 3] = Math.max(max[i % 3], value)
  })
  return { min, max }
}
