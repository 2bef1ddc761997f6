// The site as it is built for a server of files: built once for all tests that look at it.
import { preview } from 'vite'
import { buildSite, folder } from '../../../.scripts/site.mjs'
import { config, path } from './bench.js'

/** Serves it → Vite's server. `base` is the folder of the server that it stands in. */
export async function serveSite(port, base = './') {
  await buildSite()
  return preview({ ...config, base, preview: { port }, build: { outDir: path(folder) } })
}
