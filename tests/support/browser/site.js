// The site as it is built for a server of files, once for all tests that look at it; and as `npm start` serves it.
import { createServer, preview } from 'vite'
import { buildSite, folder } from '../../../.scripts/site.mjs'
import { path } from './bench.js'

const config = {
  configFile: path('web/vite.config.js'),
  logLevel: 'warn',
  clearScreen: false,
}

/** Serves it → Vite's server. `base` is the folder of the server that it stands in. */
export async function serveSite(port, base = './') {
  await buildSite()
  return preview({ ...config, base, preview: { port }, build: { outDir: path(folder) } })
}

/**
 * Serves it as `npm start` does → Vite's server. Each port has a folder of its own for the libraries that Vite
 * bundles: in a shared one, a server that starts with other plugins bundles everything anew, and so replaces files that
 * another is about to send.
 */
export async function serveSources(port, plugins = []) {
  const server = await createServer({
    ...config,
    plugins,
    cacheDir: path(`.build/vite-tests/${port}`),
    // Nobody edits the files meanwhile, and an edit would reload the page.
    server: { port, watch: null },
  })
  return server.listen()
}

/** So that what is looked at is what the server gives: for `addInitScript`. */
export const withoutWorker = () => delete Navigator.prototype.serviceWorker

/** Less motion: the examples' sketches wait to be started. */
export const calm = (size) => ({ ...size, reducedMotion: 'reduce' })
