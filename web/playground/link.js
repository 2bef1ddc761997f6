/** A sketch in a link: compressed, behind the #, which no server ever sees. */
const mark = '#sketch='

async function through(bytes, stream) {
  const body = new Blob([bytes]).stream().pipeThrough(stream)
  return new Uint8Array(await new Response(body).arrayBuffer())
}

/** → the fragment of a link, with its #. */
export async function fragmentOf(sketch) {
  const bytes = new TextEncoder().encode(JSON.stringify(sketch))
  const packed = await through(bytes, new CompressionStream('deflate-raw'))
  let text = ''
  for (const byte of packed) text += String.fromCharCode(byte)
  return mark + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

export const holdsSketch = (fragment) => fragment.startsWith(mark)

/** What `fragmentOf` was given; throws a sentence where the link is broken. */
export async function sketchOf(fragment) {
  let sketch
  try {
    const text = atob(fragment.slice(mark.length).replaceAll('-', '+').replaceAll('_', '/'))
    const packed = Uint8Array.from(text, (character) => character.charCodeAt(0))
    const bytes = await through(packed, new DecompressionStream('deflate-raw'))
    sketch = JSON.parse(new TextDecoder().decode(bytes))
  } catch {
    throw new Error('The sketch in this link is damaged: copy the whole link once more.')
  }
  if (typeof sketch?.text !== 'string')
    throw new Error('There is no sketch in this link: copy the whole link once more.')
  return sketch
}
