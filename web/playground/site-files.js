/** Files of the site that a sketch may load: those of the folder `files/`, and of packages. Nothing else of the site's origin. */
import { remember } from './remember.js'

export const root = new URL('../', location.href).href
/** The base of a sketch's relative addresses. */
export const folder = new URL('files/', location.href).href

/** Without `%`: a server might decode `%2f` and leave the folder. */
const allowed = /^(?:playground\/files|node_modules)\/[\w./-]+$/

/** Is this absolute address that of a file which a sketch may load? */
export const isSiteFile = (address) =>
  address.startsWith(root) && allowed.test(address.slice(root.length))

/** The file of that name or address as a Blob, or undefined where there is none that a sketch may load. */
export async function siteFile(name) {
  if (!URL.canParse(name, folder)) return undefined
  const address = new URL(name, folder).href
  return isSiteFile(address) ? load(address) : undefined
}

const load = remember(async (address) => {
  const response = await fetch(address)
  const type = response.headers.get('content-type') ?? ''
  // Some hosts answer with a page where there is no file.
  return response.ok && !type.startsWith('text/html') ? response.blob() : undefined
})
