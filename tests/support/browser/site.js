// Serves the site, either built for a file server (once for all tests that use it) or from its sources like `npm start`.
import { createServer, preview } from 'vite'
import { buildSite, folder } from '../../../.scripts/site.mjs'
import { path } from './bench.js'

const config = {
  configFile: path('web/vite.config.js'),
  logLevel: 'warn',
  clearScreen: false,
}

/** Serves the built site → Vite's server. `base` is its folder on the server. */
export async function serveSite(port, base = './') {
  await buildSite()
  return preview({ ...config, base, preview: { port }, build: { outDir: path(folder) } })
}

/**
 * Serves the sources like `npm start` → Vite's server. Each port has its own folder for the libraries that Vite bundles: in a shared
 * folder, a server with other plugins would bundle everything again, and so replace files that another server is about to send.
 */
export async function serveSources(port, plugins = []) {
  const server = await createServer({
    ...config,
    plugins,
    cacheDir: path(`.build/vite-tests/${port}`),
    // Does not watch files: nothing should change during the tests, and a change would reload the page.
    server: { port, watch: null },
  })
  return server.listen()
}

/** For `addInitScript`: removes service workers, so that the page uses the responses of the server. */
export const withoutWorker = () => delete Navigator.prototype.serviceWorker

/** Returns options for a visitor who prefers reduced motion: the sketches of examples do not start by themselves. */
export const withReducedMotion = (size) => ({ ...size, reducedMotion: 'reduce' })
