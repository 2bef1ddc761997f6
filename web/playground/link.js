// Stores a sketch in a link: compressed, in the fragment, which browsers do not send to the server.

const prefix = '#sketch='

/** Max size of a sketch with its settings, in bytes. Without a limit, a short link could decompress to a text that fills the memory. */
const maxBytes = 1_000_000

/** Sends bytes through a stream, and returns the result. */
async function pipeThrough(bytes, stream) {
  const parts = []
  let size = 0
  for await (const part of readAll(new Blob([bytes]).stream().pipeThrough(stream))) {
    size += part.length
    if (size > maxBytes) throw new RangeError('too large')
    parts.push(part)
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer())
}

/** Yields the parts of a stream. Some browsers' streams are not iterable. */
async function* readAll(stream) {
  const reader = stream.getReader()
  try {
    for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value
  } finally {
    await reader.cancel()
  }
}

/** Returns the fragment of a link, including the #. */
export async function encodeSketch(sketch) {
  const bytes = new TextEncoder().encode(JSON.stringify(sketch))
  const packed = await pipeThrough(bytes, new CompressionStream('deflate-raw'))
  let text = ''
  for (const byte of packed) text += String.fromCharCode(byte)
  return prefix + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

export const hasSketch = (fragment) => fragment.startsWith(prefix)

const isShort = (value) => typeof value === 'string' && value.length <= 300

/** Keeps the settings that have the expected type; drops anything else. `chosen` has the names of the chosen scripts, see hosts.js. */
function keepValid({ text, host, chosen, model, values }) {
  const isList = Array.isArray(chosen) && chosen.length <= 20 && chosen.every(isShort)
  return {
    text,
    ...(isShort(host) && { host }),
    ...(isList && { chosen }),
    ...(isShort(model) && { model }),
    ...(values && typeof values === 'object' && { values }),
  }
}

/** Inverts `encodeSketch`. If the link is broken, throws an error whose message is meant for the user. */
export async function decodeSketch(fragment) {
  let sketch
  try {
    if (fragment.length > 2 * maxBytes) throw new RangeError('too large')
    const text = atob(fragment.slice(prefix.length).replaceAll('-', '+').replaceAll('_', '/'))
    const packed = Uint8Array.from(text, (character) => character.charCodeAt(0))
    const bytes = await pipeThrough(packed, new DecompressionStream('deflate-raw'))
    sketch = JSON.parse(new TextDecoder().decode(bytes))
  } catch (error) {
    throw new Error(
      error instanceof RangeError
        ? `The sketch in this link is too large: expected at most ${maxBytes / 1e6} MB.`
        : 'The sketch in this link is damaged: copy the whole link once more.',
    )
  }
  if (typeof sketch?.text !== 'string')
    throw new Error('There is no sketch in this link: copy the whole link once more.')
  return keepValid(sketch)
}
