// Reads and writes GLB files according to the specification (glTF 2.0, sections 3.6 and 4.4), without using the library.

const componentTypes = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
}
const sizes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }

/** Returns the document `json`, the `chunks`, and functions that return the bytes of a buffer view and the numbers of an accessor. */
export function readGlb(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  const word = (at) => view.getUint32(at, true)
  if (word(0) !== 0x46546c67 || word(4) !== 2 || word(8) !== bytes.length)
    throw new Error('no GLB header')
  const chunks = []
  for (let at = 12; at < bytes.length; at += 8 + word(at))
    chunks.push({ type: word(at + 4), bytes: bytes.slice(at + 8, at + 8 + word(at)) })
  const [jsonChunk, binary] = chunks
  if (jsonChunk.type !== 0x4e4f534a) throw new Error('the first chunk is not JSON')
  const json = JSON.parse(new TextDecoder().decode(jsonChunk.bytes))
  const viewBytes = (i) => {
    const { byteOffset = 0, byteLength } = json.bufferViews[i]
    return binary.bytes.slice(byteOffset, byteOffset + byteLength)
  }
  const accessor = (i) => {
    const { bufferView, componentType, count, type } = json.accessors[i]
    const numbers = new componentTypes[componentType](viewBytes(bufferView).buffer)
    if (numbers.length !== count * sizes[type])
      throw new Error(
        `accessor ${i}: expected ${count * sizes[type]} numbers, got ${numbers.length}`,
      )
    return numbers
  }
  return { json, chunks, viewBytes, accessor }
}

/** Returns the bytes of a GLB file with a document and optional binary data. */
export function writeGlb(json, binary) {
  const text = new TextEncoder().encode(typeof json === 'string' ? json : JSON.stringify(json))
  const chunks = [[0x4e4f534a, pad(text, 0x20)]]
  if (binary) chunks.push([0x004e4942, pad(binary, 0)])
  const length = chunks.reduce((sum, [, bytes]) => sum + 8 + bytes.length, 12)
  const file = new Uint8Array(length)
  const view = new DataView(file.buffer)
  ;[0x46546c67, 2, length].forEach((word, i) => view.setUint32(4 * i, word, true))
  let at = 12
  for (const [type, bytes] of chunks) {
    view.setUint32(at, bytes.length, true)
    view.setUint32(at + 4, type, true)
    file.set(bytes, at + 8)
    at += 8 + bytes.length
  }
  return file
}

function pad(bytes, filler) {
  const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4).fill(filler)
  padded.set(bytes)
  return padded
}
