/** Writes an uncompressed zip archive: large files are images or minified scripts, and the rest is small. */

const table = Uint32Array.from({ length: 256 }, (_, i) => {
  let sum = i
  for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1
  return sum
})

function checksum(bytes) {
  let sum = 0xffffffff
  for (const byte of bytes) sum = table[(sum ^ byte) & 255] ^ (sum >>> 8)
  return ~sum >>> 0
}

/** Encodes [size, value] pairs in little-endian order. */
function encodeFields(...list) {
  const view = new DataView(new ArrayBuffer(list.reduce((sum, [size]) => sum + size, 0)))
  let at = 0
  for (const [size, value] of list) {
    if (size === 2) view.setUint16(at, value, true)
    else view.setUint32(at, value, true)
    at += size
  }
  return new Uint8Array(view.buffer)
}

/** 1 January 1980, the first date of the format, so that an archive does not depend on when it was made. */
const day = 33
/** The flag of names in UTF-8. */
const utf8Flag = 0x800

/** Returns whether every unpacker, on every system, puts a file of that name inside of its target folder. */
const isInside = (name) =>
  /^[^\\:\0-\x1f]+$/.test(name) &&
  name.split('/').every((part) => part !== '' && part !== '.' && part !== '..')

/** @param files maps name → text or bytes @returns the archive's bytes, in parts for a Blob */
export function zip(files) {
  for (const name of Object.keys(files))
    if (!isInside(name)) throw new Error(`“${name}” cannot be packed: give the file another name.`)
  const parts = []
  const entries = []
  let at = 0
  for (const [name, content] of Object.entries(files)) {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content
    const nameBytes = new TextEncoder().encode(name)
    const sharedFields = [
      [2, 20],
      [2, utf8Flag],
      [2, 0],
      [2, 0],
      [2, day],
      [4, checksum(bytes)],
      [4, bytes.length],
      [4, bytes.length],
      [2, nameBytes.length],
      [2, 0],
    ]
    const head = encodeFields([4, 0x04034b50], ...sharedFields)
    parts.push(head, nameBytes, bytes)
    const more = [[2, 0], [2, 0], [2, 0], [4, 0], [4, at]] // prettier-ignore
    entries.push(encodeFields([4, 0x02014b50], [2, 20], ...sharedFields, ...more), nameBytes)
    at += head.length + nameBytes.length + bytes.length
  }
  const size = entries.reduce((sum, { length }) => sum + length, 0)
  const count = entries.length / 2
  const end = encodeFields([4, 0x06054b50], [2, 0], [2, 0], [2, count], [2, count], [4, size], [4, at], [2, 0]) // prettier-ignore
  return [...parts, ...entries, end]
}
