/** The only files of the site's origin that a sketch may load: the gallery's models, its font, and a package's shader. */
import { models } from './offset.js'
import { remember } from './remember.js'

export const root = new URL('../', location.href).href
/** The base of a sketch's relative addresses. */
export const folder = new URL('files/', location.href).href

const files = [
  ...models.map((name) => `playground/files/${name}.obj`),
  'playground/files/fredoka.woff',
  'node_modules/glsl-noise/simplex/3d.glsl',
]
const allowed = new Set(files.map((path) => root + path))

/** Loads the file of that name or address as a Blob; undefined if a sketch may not load it or it does not exist. */
export async function siteFile(name) {
  if (!URL.canParse(name, folder)) return undefined
  const address = new URL(name, folder).href
  return allowed.has(address) ? load(address) : undefined
}

const load = remember(async (address) => {
  const response = await fetch(address)
  const type = response.headers.get('content-type') ?? ''
  // Some hosts answer with an HTML page if a file does not exist.
  return response.ok && !type.startsWith('text/html') ? response.blob() : undefined
})
