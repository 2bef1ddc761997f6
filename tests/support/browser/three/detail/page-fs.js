// Takes the place of node:fs in a page, for tests/warps/sketches.js: reads files of the repository from the server.
export function readFileSync(url) {
  const request = new XMLHttpRequest()
  request.open('GET', url, false)
  request.send()
  return request.responseText
}

/** Returns the folders of the sketches to read, which the page has set. */
export const readdirSync = () => globalThis.sketchFolders
