// The local server of the benchmark's pages, which are not part of the published site.
import { readFileSync } from 'node:fs'
import { createServer } from 'vite'
import { path } from '../../lib/files.mjs'

/** The benchmark also loads p5 1.x, which the gallery's server does not serve. */
const p5v1 = 'node_modules/p5-v1/lib/p5.min.js'
const oldP5 = {
  name: 'old-p5',
  configureServer: ({ middlewares }) =>
    void middlewares.use(`/${p5v1}`, (request, response) => {
      response.setHeader('Content-Type', 'text/javascript; charset=utf-8')
      response.end(readFileSync(path(p5v1)))
    }),
}

/** Starts the server. Returns { url, close() }. */
export async function serveBench() {
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    clearScreen: false,
    cacheDir: path('.build/vite-bench'),
    plugins: [oldP5],
    // If Vite found this dependency late, it would reload the page in the middle of a measurement.
    optimizeDeps: { include: ['gl-matrix'] },
    server: {
      port: 5400,
      // Nobody edits the files meanwhile, and an edit would reload the page.
      watch: null,
      hmr: false,
      // Isolated pages have a clock with a resolution of 5 µs instead of 100.
      headers: {
        'Cross-Origin-Opener-Policy': 'same-origin',
        'Cross-Origin-Embedder-Policy': 'require-corp',
      },
    },
  })
  await server.listen()
  return { url: server.resolvedUrls.local[0], close: () => server.close() }
}
