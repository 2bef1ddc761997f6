// A file server like many hosts of static sites: its addresses have no .html, and it redirects requests with .html.
import { readFile, stat } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname, join } from 'node:path'

const types = {
  '.css': 'text/css',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
}
const kindOf = async (file) => {
  const entry = await stat(file).catch(() => undefined)
  return entry?.isDirectory() ? 'folder' : entry && 'file'
}

/**
 * Serves the files of `folder` below `base` → { url, close() }. With `slashes`, a folder x is served at x/, and x redirects to x/; without
 * `slashes` it is served at both, and x/index.html redirects to x.
 */
export async function serveCleanly(folder, base, { slashes = true } = {}) {
  const server = createServer(async (request, response) => {
    const { pathname, search } = new URL(request.url, 'http://localhost')
    const redirect = (path) => response.writeHead(308, { location: path + search }).end()
    const clean = pathname.replace(slashes ? /(?:(?<=\/)index)?\.html$/ : /(?:\/index)?\.html$/, '')
    if (clean !== pathname) return redirect(clean)
    const requested = join(folder, decodeURIComponent(pathname.slice(base.length + 1)))
    const kind = await kindOf(requested)
    if (slashes && kind === 'folder' && !pathname.endsWith('/')) return redirect(`${pathname}/`)
    const file =
      kind === 'folder' ? join(requested, 'index.html') : kind ? requested : `${requested}.html`
    const content = await readFile(file).catch(() => undefined)
    if (content) response.setHeader('content-type', types[extname(file)] ?? 'text/plain')
    response.writeHead(content ? 200 : 404).end(content)
  })
  await new Promise((resolve) => server.listen(0, resolve))
  return {
    url: `http://localhost:${server.address().port}${base}/`,
    close() {
      server.closeAllConnections()
      server.close()
    },
  }
}
