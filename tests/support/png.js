// Encodes a picture as a PNG file (PNG specification, section 5), with 8 bits per channel.
import { crc32, deflateSync } from 'node:zlib'

const crc = crc32 ?? slowCrc32

/** Encodes a picture; `pixel(x, y)` returns [red, green, blue]. */
export function png(width, height, pixel) {
  const rows = []
  for (let y = 0; y < height; y++)
    rows.push(0, ...Array.from({ length: width }, (_, x) => pixel(x, y)).flat())
  return encodeFile(width, height, 2, Buffer.from(rows))
}

/** Encodes an image with bytes of red, green, blue and alpha, from the top left. */
export function encodeImage({ width, height, data }) {
  const rows = Buffer.alloc(height * (1 + 4 * width))
  for (let y = 0; y < height; y++)
    rows.set(data.subarray(4 * width * y, 4 * width * (y + 1)), y * (1 + 4 * width) + 1)
  return encodeFile(width, height, 6, rows)
}

function encodeFile(width, height, colorType, rows) {
  const header = Buffer.alloc(13)
  header.writeUInt32BE(width, 0)
  header.writeUInt32BE(height, 4)
  header.set([8, colorType, 0, 0, 0], 8)
  const chunks = [
    ['IHDR', header],
    ['IDAT', deflateSync(rows)],
    ['IEND', Buffer.alloc(0)],
  ]
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])
  return new Uint8Array(Buffer.concat([signature, ...chunks.map(encodeChunk)]))
}

function encodeChunk([type, data]) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data])
  const lengthAndSum = Buffer.alloc(8)
  lengthAndSum.writeUInt32BE(data.length, 0)
  lengthAndSum.writeUInt32BE(crc(body) >>> 0, 4)
  return Buffer.concat([lengthAndSum.subarray(0, 4), body, lengthAndSum.subarray(4)])
}

/** Replaces Node's `crc32`, which exists only since 22.2. */
function slowCrc32(bytes) {
  let sum = -1
  for (const byte of bytes) {
    sum ^= byte
    for (let i = 0; i < 8; i++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0)
  }
  return ~sum
}
