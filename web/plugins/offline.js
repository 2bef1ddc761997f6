/**
 * Vite plugin: the service worker of a built site, which makes its pages and sketches work without a network once any of its pages was seen.
 * Every build has a name of its own, by what is in it, and takes the place of the one before as a whole.
 */
import { createHash } from 'node:crypto'

/**
 * Written into sw.js. It takes over once it has kept `files` and, unless one saves data, `models`, which are large; `same` has the
 * file that holds what one says, too.
 */
function worker({ name, files, models, same }) {
  const scope = self.registration.scope

  /** What could not be kept is kept when it is first asked for. */
  async function keep(files) {
    const cache = await caches.open(name)
    const isKept = await Promise.all(files.map((file) => cache.match(scope + file)))
    await Promise.allSettled(
      files
        .filter((_, i) => !isKept[i])
        .map((file) => cache.add(new Request(scope + file, { cache: 'no-cache' }))),
    )
  }

  async function answer(request) {
    const url = new URL(request.url)
    url.search = url.hash = ''
    if (url.pathname.endsWith('/')) url.pathname += 'index.html'
    const file = url.href.slice(scope.length)
    const address = scope + (same[file] ?? file)
    const cache = await caches.open(name)
    const kept = await cache.match(address)
    if (kept) return kept
    const response = await fetch(request)
    if (request.method === 'GET' && response.status === 200) cache.put(address, response.clone())
    return response
  }

  self.addEventListener('install', (event) => {
    self.skipWaiting()
    event.waitUntil(keep(navigator.connection?.saveData ? files : [...files, ...models]))
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
    // p5 asks for the head of a font before it loads it.
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
      // Many sketches load the same model.
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
