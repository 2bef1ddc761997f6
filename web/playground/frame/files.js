// Before the libraries: files that the sketch loads by name come from `sketchFiles`, which has an address of their data for each. In the
// playground these are the files that were dropped on it and those that the sketch names; in a saved page all that it names, since a
// page that was opened as a file can read no other.
{
  const { fetch, FontFace, playground } = window
  const address = (name) => {
    try {
      return new URL(name, document.baseURI).href
    } catch {
      // Not an address.
    }
  }
  const byAddress = new Map(
    Object.entries(window.sketchFiles).map(([name, data]) => [address(name), data]),
  )
  /** The address of the file's data, or undefined. p5 passes a name, an address or a Request. */
  const dataOf = (from) => byAddress.get(address(from?.url ?? String(from)))

  // p5 asks for the head of a font before it loads it, which data lack.
  window.fetch = async (from, options) => {
    const data = dataOf(from)
    if (data) return fetch(data)
    const found = await playground?.findFile(address(from?.url ?? String(from)))
    return found ?? fetch(from, options)
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
