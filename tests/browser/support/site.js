// The site as it is built for a server of files: built once for all tests that look at it.
import { preview } from 'vite'
import { buildSite, folder } from '../../../.scripts/site.mjs'
import { config, path } from './bench.js'

/** Serves it → Vite's server. `base` is the folder of the server that it stands in. */
export async function serveSite(port, base = './') {
  await buildSite()
  return preview({ ...config, base, preview: { port }, build: { outDir: path(folder) } })
}

/** So that what is looked at is what the server gives: for `addInitScript`. */
export const withoutWorker = () => delete Navigator.prototype.serviceWorker

/** Less motion: the examples' sketches wait to be started. */
export const calm = (size) => ({ ...size, reducedMotion: 'reduce' })
