// Passes bytes to a page and back over HTTP: passing the data of 50,000 vertices through Playwright as text would take a second.
import { createServer } from 'node:http'

const collect = async (stream) => {
  const chunks = []
  for await (const chunk of stream) chunks.push(chunk)
  return Buffer.concat(chunks)
}

/**
 * Serves an empty page at `url`. In the page, `fetch('/given')` returns the bytes last passed to `give`. `take()` returns the body that the
 * page last sent by POST, as an ArrayBuffer.
 */
export async function serveBytes() {
  let given = new Uint8Array()
  let taken

  const server = createServer(async (request, response) => {
    if (request.method === 'POST') {
      taken = await collect(request)
      response.end()
    } else if (request.url === '/given') response.end(given)
    else response.setHeader('content-type', 'text/html').end('<link rel="icon" href="data:,">')
  })
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening))

  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    give: (bytes) => (given = bytes),
    take: () => taken.buffer.slice(taken.byteOffset, taken.byteOffset + taken.byteLength),
    close: () => {
      server.closeAllConnections()
      server.close()
    },
  }
}
