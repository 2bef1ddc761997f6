/**
 * Prepares modules for an import map whose addresses are data or blobs. Relative imports become names, since a data: address has no folder
 * against which they could be resolved.
 */
const importPattern = /(\bfrom\s*|\bimport\s*\(?\s*)(["'])([^"'\n]+)\2/g

/**
 * Collects all modules that `text` imports, directly or indirectly. Returns { name: { path, text } }. `modules` maps names, or prefixes
 * that end with a slash, to paths; `read` returns the text at a path.
 */
export async function moduleTexts(text, modules, read) {
  const imports = {}

  /** Resolves an import in the module at `path` to a path; undefined if it names no known module. */
  function resolve(name, path) {
    if (/^\.\.?\//.test(name)) return path && join(path, name)
    const key = Object.keys(modules).find((key) =>
      key.endsWith('/') ? name.startsWith(key) : name === key,
    )
    return key && modules[key] + name.slice(key.length)
  }
  /** Returns the name of the module at `path`. It is always the same: under a second name, the module would be loaded twice. */
  function nameOf(path) {
    for (const [key, place] of Object.entries(modules)) {
      if (place === path) return key
      if (key.endsWith('/') && path.startsWith(place)) return key + path.slice(place.length)
    }
    return `data/${path.replace(/^[./]+/, '')}`
  }

  /** Adds all imports of `text` to `imports` and returns the text with its imports replaced by names. */
  async function replaceImports(text, path) {
    const names = {}
    for (const [, , , name] of text.matchAll(importPattern)) {
      const imported = resolve(name, path)
      if (!imported || name in names) continue
      names[name] = path ? nameOf(imported) : name
      if (names[name] in imports) continue
      // Set before reading, because modules can import each other.
      imports[names[name]] = {}
      const text = await replaceImports(await read(imported), imported)
      Object.assign(imports[names[name]], { path: imported, text })
    }
    return text.replaceAll(importPattern, (whole, head, quote, name) =>
      name in names ? head + quote + names[name] + quote : whole,
    )
  }
  await replaceImports(text)
  return imports
}

/** Converts the modules that `text` imports to data: addresses. Returns { name: address }. */
export async function modulesAsData(text, modules, read) {
  const texts = await moduleTexts(text, modules, read)
  const dataOf = ({ text }) => `data:text/javascript;charset=utf-8,${encodeURIComponent(text)}`
  return Object.fromEntries(Object.entries(texts).map(([name, each]) => [name, dataOf(each)]))
}

/** Resolves `name` against a relative path, which the URL constructor cannot. */
function join(path, name) {
  const parts = path.split('/').slice(0, -1)
  for (const part of name.split('/')) {
    const isUp = part === '..' && parts.length && parts.at(-1) !== '..'
    if (isUp) parts.pop()
    else if (part !== '.') parts.push(part)
  }
  return parts.join('/')
}
