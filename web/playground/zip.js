/** A zip archive of a few files, as they are: what they weigh is pictures and scripts that are packed already, or little text. */

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

/** Numbers as [size, value], lowest byte first. */
function words(...list) {
  const view = new DataView(new ArrayBuffer(list.reduce((sum, [size]) => sum + size, 0)))
  let at = 0
  for (const [size, value] of list) {
    if (size === 2) view.setUint16(at, value, true)
    else view.setUint32(at, value, true)
    at += size
  }
  return new Uint8Array(view.buffer)
}

/** The first day that an archive knows: what is in it says nothing of when it was made. */
const day = 33
/** The flag of names in UTF-8. */
const inUTF8 = 0x800

/** Does every unpacker put a file of that name below its folder, on every system? */
const isInside = (name) =>
  /^[^\\:\0-\x1f]+$/.test(name) &&
  name.split('/').every((part) => part !== '' && part !== '.' && part !== '..')

/** { name: text or bytes } → its bytes, in parts for a Blob. */
export function zip(files) {
  for (const name of Object.keys(files))
    if (!isInside(name)) throw new Error(`“${name}” cannot be packed: give the file another name.`)
  const parts = []
  const entries = []
  let at = 0
  for (const [name, content] of Object.entries(files)) {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content
    const title = new TextEncoder().encode(name)
    const facts = [
      [2, 20],
      [2, inUTF8],
      [2, 0],
      [2, 0],
      [2, day],
      [4, checksum(bytes)],
      [4, bytes.length],
      [4, bytes.length],
      [2, title.length],
      [2, 0],
    ]
    const head = words([4, 0x04034b50], ...facts)
    parts.push(head, title, bytes)
    const more = [[2, 0], [2, 0], [2, 0], [4, 0], [4, at]] // prettier-ignore
    entries.push(words([4, 0x02014b50], [2, 20], ...facts, ...more), title)
    at += head.length + title.length + bytes.length
  }
  const size = entries.reduce((sum, { length }) => sum + length, 0)
  const count = entries.length / 2
  const end = words([4, 0x06054b50], [2, 0], [2, 0], [2, count], [2, count], [4, size], [4, at], [2, 0]) // prettier-ignore
  return [...parts, ...entries, end]
}
