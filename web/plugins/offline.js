/**
 * Vite plugin: the service worker of a built site, which makes all pages and sketches work offline after a visit to any page. Each
 * build's cache is named by a hash of its content and replaces the previous one as a whole.
 */
import { createHash } from 'node:crypto'

/**
 * The code of sw.js. It takes over after caching `files` and, unless the visitor saves data, `models`, which are large; `same` maps
 * a duplicate to the file with the same content.
 */
function worker({ name, files, models, same }) {
  const scope = self.registration.scope

  const sitePaths = new Set([...files, ...models, ...Object.keys(same)])

  /** Copies a response without its `redirected` flag, since a navigation rejects it. Some servers redirect x.html to x. */
  async function withoutRedirect(response) {
    if (!response.redirected) return response
    const { status, statusText, headers } = response
    return new Response(await response.blob(), { status, statusText, headers })
  }

  async function fetchInto(cache, file) {
    const response = await fetch(scope + file, { cache: 'no-cache', priority: 'low' })
    if (response.ok) await cache.put(scope + file, await withoutRedirect(response))
  }

  /** Caches the files. A file whose download fails is cached at its first request. */
  async function cacheAll(files) {
    const cache = await caches.open(name)
    const remaining = [...files]
    // Only four at a time, so that the visitor's own requests need not wait.
    const cacheNext = async () => {
      for (let file = remaining.shift(); file; file = remaining.shift())
        if (!(await cache.match(scope + file))) await fetchInto(cache, file).catch(() => {})
    }
    await Promise.all([cacheNext(), cacheNext(), cacheNext(), cacheNext()])
  }

  async function answer(request) {
    const url = new URL(request.url)
    url.search = url.hash = ''
    const path = url.href.slice(scope.length)
    const file =
      [path, `${path}.html`, `${path}index.html`].find((file) => sitePaths.has(file)) ?? path
    // Without the slash, the page's relative addresses would be resolved against the parent folder.
    if (sitePaths.has(`${path}/index.html`)) {
      const folder = new URL(request.url)
      folder.pathname += '/'
      return Response.redirect(folder)
    }
    const address = scope + (same[file] ?? file)
    const cache = await caches.open(name)
    const cached = await cache.match(address)
    if (cached) return cached
    const response = await fetch(request)
    if (request.method === 'GET' && response.status === 200)
      withoutRedirect(response.clone())
        .then((copy) => cache.put(address, copy))
        .catch(() => {})
    return response
  }

  self.addEventListener('install', (event) => {
    self.skipWaiting()
    event.waitUntil(cacheAll(navigator.connection?.saveData ? files : [...files, ...models]))
  })
  self.addEventListener('activate', (event) => {
    const others = async () =>
      (await caches.keys()).filter((key) => key.startsWith('warpjet-') && key !== name)
    event.waitUntil(
      others()
        .then((keys) => Promise.all(keys.map((key) => caches.delete(key))))
        .then(() => self.clients.claim()),
    )
  })
  self.addEventListener('fetch', (event) => {
    const { method, url } = event.request
    // p5 sends a HEAD request for a font before it loads it.
    const isRead = method === 'GET' || method === 'HEAD'
    if (isRead && url.startsWith(scope)) event.respondWith(answer(event.request))
  })
}

export const offline = () => ({
  name: 'offline',
  apply: 'build',
  generateBundle: {
    order: 'post',
    handler(_, bundle) {
      const hash = createHash('sha256')
      const all = Object.keys(bundle).sort()
      const contentOf = (file) => bundle[file].source ?? bundle[file].code
      const isModel = (file) => file.endsWith('.obj')
      for (const file of all) hash.update(file).update(contentOf(file))
      const name = `warpjet-${hash.digest('hex').slice(0, 12)}`
      // Many sketches load the same model: cache it once.
      const firsts = new Map()
      const same = {}
      for (const file of all.filter(isModel)) {
        const text = String(contentOf(file))
        if (firsts.has(text)) same[file] = firsts.get(text)
        else firsts.set(text, file)
      }
      const files = all.filter((file) => !isModel(file))
      const setting = { name, files, models: [...firsts.values()], same }
      this.emitFile({
        type: 'asset',
        fileName: 'sw.js',
        source: `(${worker})(${JSON.stringify(setting)})\n`,
      })
    },
  },
})
