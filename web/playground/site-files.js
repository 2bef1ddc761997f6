/** Files of the site that a sketch may load: those of the folder `files/`, and of packages. Nothing else of the site's origin. */
import { remember } from './remember.js'

export const root = new URL('../', location.href).href
/** What a sketch's relative addresses start from. */
export const folder = new URL('files/', location.href).href

/** As a server decodes no further: no `%2f` that would lead out of a folder. */
const allowed = /^(?:playground\/files|node_modules)\/[\w./-]+$/

/** Whether a sketch may load the file at that address, which `URL` has made whole. */
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
