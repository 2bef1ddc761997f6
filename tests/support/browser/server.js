// Serves HTML that tests write, and files of this repository, on localhost.
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = new URL('../../../', import.meta.url)

const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
}

/** Lets browsers cache libraries: they then also cache the compiled code, which for p5 halves the time to open a page. */
const cacheHeaders = (pathname) =>
  pathname.startsWith('/node_modules/') ? { 'cache-control': 'max-age=86400' } : {}

/**
 * Starts a server. Returns { url, page(html), close() }. `page` returns the address of a page with this HTML; `/` is an empty page, and
 * every other path is a file of the repository, such as `/dist/p5.js`.
 */
export async function servePages() {
  const pages = []

  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost')
    try {
      const page = pathname === '/' ? '' : pages[/^\/page\/(\d+)$/.exec(pathname)?.[1]]
      const body = page ?? (await readFile(fileURLToPath(new URL(`.${pathname}`, root))))
      const type =
        page !== undefined ? 'text/html' : (types[extname(pathname)] ?? 'application/octet-stream')
      response
        .writeHead(200, { 'content-type': `${type}; charset=utf-8`, ...cacheHeaders(pathname) })
        .end(body)
    } catch {
      // Browsers request an icon on their own, and would print that it is missing.
      response.writeHead(pathname === '/favicon.ico' ? 204 : 404).end()
    }
  })

  await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
  const url = `http://localhost:${server.address().port}`
  return {
    url,
    page: (html) => `${url}/page/${pages.push(html) - 1}`,
    close: () =>
      new Promise((closed) => {
        server.close(closed)
        server.closeAllConnections()
      }),
  }
}
