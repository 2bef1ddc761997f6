/**
 * Modules for an import map whose addresses are data or blobs: what one imports of its neighbours by a relative path gets a name,
 * since data lies in no folder.
 */
const asked = /(\bfrom\s*|\bimport\s*\(?\s*)(["'])([^"'\n]+)\2/g

/**
 * All that `text` imports, and what that imports. `modules` maps names, or beginnings of names with a slash, to paths; `read`
 * gives the text of a path → { name: { path, text } }.
 */
export async function moduleTexts(text, modules, read) {
  const imports = {}

  /** The path that is meant, from the module at `path`; nothing for what is no module's name. */
  function resolve(name, path) {
    if (/^\.\.?\//.test(name)) return path && join(path, name)
    const key = Object.keys(modules).find((key) =>
      key.endsWith('/') ? name.startsWith(key) : name === key,
    )
    return key && modules[key] + name.slice(key.length)
  }
  /** One name for each, or it would be there twice. */
  function nameOf(path) {
    for (const [key, place] of Object.entries(modules)) {
      if (place === path) return key
      if (key.endsWith('/') && path.startsWith(place)) return key + path.slice(place.length)
    }
    return `data/${path.replace(/^[./]+/, '')}`
  }

  /** The text with names alone, once all that it imports is in the map. */
  async function named(text, path) {
    const names = {}
    for (const [, , , name] of text.matchAll(asked)) {
      const found = resolve(name, path)
      if (!found || name in names) continue
      const known = nameOf(found)
      names[name] = path ? known : name
      if (names[name] in imports) continue
      // Before it is read: modules may ask for each other.
      imports[names[name]] = {}
      const text = await named(await read(found), found)
      Object.assign(imports[names[name]], { path: found, text })
    }
    return text.replaceAll(asked, (whole, head, quote, name) =>
      name in names ? head + quote + names[name] + quote : whole,
    )
  }
  await named(text)
  return imports
}

/** Makes data: addresses of the modules → { name: address }. */
export async function modulesAsData(text, modules, read) {
  const texts = await moduleTexts(text, modules, read)
  const dataOf = ({ text }) => `data:text/javascript;charset=utf-8,${encodeURIComponent(text)}`
  return Object.fromEntries(Object.entries(texts).map(([name, each]) => [name, dataOf(each)]))
}

/** `path` is relative, so that it cannot be a URL's. */
function join(path, name) {
  const parts = path.split('/').slice(0, -1)
  for (const part of name.split('/')) {
    const isUp = part === '..' && parts.length && parts.at(-1) !== '..'
    if (isUp) parts.pop()
    else if (part !== '.') parts.push(part)
  }
  return parts.join('/')
}
