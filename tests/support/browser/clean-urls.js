// A file server that works like many hosts of static sites: addresses have no .html, and requests with .html are redirected.
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
  const found = await stat(file).catch(() => undefined)
  return found?.isDirectory() ? 'folder' : found && 'file'
}

/**
 * Serves the files of `folder` below `/base/` → { url, close() }. A folder is served at x/, and x redirects there; without
 * `slashes` it is served at both, and its index.html redirects to x.
 */
export async function serveCleanly(folder, base, { slashes = true } = {}) {
  const server = createServer(async (request, response) => {
    const { pathname, search } = new URL(request.url, 'http://localhost')
    const lead = (path) => response.writeHead(308, { location: path + search }).end()
    const clean = pathname.replace(slashes ? /(?:(?<=\/)index)?\.html$/ : /(?:\/index)?\.html$/, '')
    if (clean !== pathname) return lead(clean)
    const asked = join(folder, decodeURIComponent(pathname.slice(base.length + 1)))
    const kind = await kindOf(asked)
    if (slashes && kind === 'folder' && !pathname.endsWith('/')) return lead(`${pathname}/`)
    const file = kind === 'folder' ? join(asked, 'index.html') : kind ? asked : `${asked}.html`
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
