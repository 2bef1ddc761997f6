/**
 * Elements of storage buffers in the hooks of a sketch on WEBGPU. An element whose index is constant over the surface, such as the number
 * of the instance, becomes a uniform in the source that is differentiated; in the code generated from it, the uniform becomes the
 * original expression again.
 */
import type { ModifiedShader } from './modified-shader.js'

export interface StorageReads {
  /** Returns source in which these elements are uniforms. */
  replace(source: string): string
  /** Returns the declarations of the uniforms, once all source is replaced. */
  declarations(): string
  /** Returns code in which the uniforms are elements again. */
  restore(code: string): string
  /** Returns the name of a storage buffer that `source`, a result of `replace`, still reads; `undefined` if it reads none. */
  findUnreplaced(source: string): string | undefined
}

/** Matches words in an index that are constant over the surface. */
const constantWord = /^(?:instanceID|hooks|[iuf]32|floor|ceil|round|min|max|abs|clamp)$/

/** Returns the position after the bracket that closes the one at `open`. */
function endOfBracket(source: string, open: number): number {
  let depth = 0
  for (let i = open; i < source.length; i++) {
    if (source[i] === '[') depth++
    if (source[i] === ']' && --depth === 0) return i + 1
  }
  return source.length
}

/** Maps names of storage buffers → the types of their elements. */
function storagesIn(declarations: string): ReadonlyMap<string, string> {
  const found = declarations.matchAll(
    /var<storage[^>]*>\s+(\w+)\s*:\s*array<\s*([\w<>]+?)\s*(?:,\s*\w+\s*)?>\s*;/g,
  )
  return new Map([...found].map(([, name, type]) => [name!, type!]))
}

/** Maps the members of the structure `type` → their types; `undefined` if `type` is not a structure. */
function membersOf(type: string, declarations: string): ReadonlyMap<string, string> | undefined {
  const [, members] = new RegExp(`\\bstruct\\s+${type}\\s*\\{([^}]*)\\}`).exec(declarations) ?? []
  return members === undefined
    ? undefined
    : new Map(
        [...members.matchAll(/(\w+)\s*:\s*([\w<>]+)/g)].map(([, name, member]) => [name!, member!]),
      )
}

const isConstant = (index: string) =>
  (index.match(/(?<![.\w])[A-Za-z_]\w*/g) ?? []).every((word) => constantWord.test(word))

export function storageReadsOf({ hooks }: ModifiedShader): StorageReads {
  const declared = `${hooks.vertex.declarations ?? ''}\n${hooks.declarations ?? ''}`
  const storages = storagesIn(declared)
  /** Maps the source of an element, such as `data[instanceID]`, → its uniform. */
  const uniforms = new Map<string, { name: string; type: string }>()
  const pattern = new RegExp(`(?<![.\\w])(?:${[...storages.keys()].join('|')})\\s*\\[`)

  function elementAt(source: string, start: number) {
    const storage = /^\w+/.exec(source.slice(start))![0]
    const open = source.indexOf('[', start)
    const end = endOfBracket(source, open)
    const type = storages.get(storage)!
    const members = membersOf(type, declared)
    const [member = '', name] = (members && /^\s*\.\s*(\w+)/.exec(source.slice(end))) ?? []
    return {
      storage,
      index: source.slice(open + 1, end - 1),
      end: end + member.length,
      type: members ? members.get(name ?? '') : type,
    }
  }

  function replace(source: string): string {
    const start = storages.size ? source.search(pattern) : -1
    if (start < 0) return source
    const { index, end, type } = elementAt(source, start)
    const element = source.slice(start, end)
    if (!type || !isConstant(index)) {
      const afterBracket = source.indexOf('[', start) + 1
      return source.slice(0, afterBracket) + replace(source.slice(afterBracket))
    }
    let uniform = uniforms.get(element)
    if (!uniform)
      uniforms.set(element, (uniform = { name: `warpjetStorage${uniforms.size}`, type }))
    return `${source.slice(0, start)}${uniform.name}${replace(source.slice(end))}`
  }

  return {
    replace,
    declarations: () =>
      Array.from(uniforms.values(), ({ name, type }) => `var<uniform> ${name}: ${type};`).join(
        '\n',
      ),
    restore: (code) =>
      [...uniforms].reduce(
        (restored, [element, { name }]) =>
          restored.replace(new RegExp(`\\b${name}\\b`, 'g'), () => element),
        code,
      ),
    findUnreplaced: (source) =>
      storages.size ? /\w+/.exec(pattern.exec(source)?.[0] ?? '')?.[0] : undefined,
  }
}
