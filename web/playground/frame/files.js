// Runs before the libraries, and redirects files that the sketch loads by name to `sketchFiles`, which maps name → data address. In the
// playground these are the dropped files and those that the sketch names. A saved page contains all files that the sketch names, since
// a page opened from disk cannot read others.
{
  const { fetch, FontFace, playground } = window
  const resolveAddress = (name) => {
    try {
      return new URL(name, document.baseURI).href
    } catch {
      // Not an address.
    }
  }
  const byAddress = new Map(
    Object.entries(window.sketchFiles).map(([name, data]) => [resolveAddress(name), data]),
  )
  /** Returns the address of the file's data, or undefined. p5 passes a name, an address or a Request. */
  const dataOf = (from) => byAddress.get(resolveAddress(from?.url ?? String(from)))

  // p5 requests a font by HEAD before it loads it, which data: addresses do not support.
  window.fetch = async (from, options) => {
    const data = dataOf(from)
    if (data) return fetch(data)
    const response = await playground?.findFile(resolveAddress(from?.url ?? String(from)))
    return response ?? fetch(from, options)
  }

  window.FontFace = class extends FontFace {
    constructor(family, from, ...more) {
      const [, name] = /^url\(["']?(.*?)["']?\)/.exec(from) ?? []
      const data = name && dataOf(name)
      super(family, data ? `url(${data})` : from, ...more)
    }
  }

  for (const { prototype } of [HTMLImageElement, HTMLMediaElement, HTMLSourceElement]) {
    const { get, set } = Object.getOwnPropertyDescriptor(prototype, 'src')
    Object.defineProperty(prototype, 'src', {
      configurable: true,
      enumerable: true,
      get,
      set(name) {
        set.call(this, dataOf(name) ?? name)
      },
    })
  }

  const { open } = XMLHttpRequest.prototype
  XMLHttpRequest.prototype.open = function (method, name, ...more) {
    return open.call(this, method, dataOf(name) ?? name, ...more)
  }
}
