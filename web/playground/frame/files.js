// Before the libraries: files that the sketch asks for by name, as data. In the playground those that were dropped on it, in
// a downloaded page all of them, since a page that was opened as a file can read no other.
{
  const { fetch, FontFace } = window
  const address = (name) => new URL(name, document.baseURI).href
  const byAddress = Object.fromEntries(
    Object.entries(window.sketchFiles).map(([name, data]) => [address(name), data]),
  )
  /** The file's data, or nothing. p5 asks with an address or a Request, and first for the head alone, which data lack. */
  const dataOf = (from) => byAddress[address(from?.url ?? String(from))]
  window.fetch = (from, options) => {
    const data = dataOf(from)
    return data ? fetch(data) : fetch(from, options)
  }
  window.FontFace = class extends FontFace {
    constructor(family, from, ...more) {
      const [, name] = /^url\(["']?(.*?)["']?\)/.exec(from) ?? []
      const data = name && dataOf(name)
      super(family, data ? `url(${data})` : from, ...more)
    }
  }
}
