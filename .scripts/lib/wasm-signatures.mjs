// Reads the signatures of exported functions from the sections of a wasm module.

const kinds = { 0x7f: 'number', 0x7e: 'bigint', 0x7d: 'number', 0x7c: 'number' }

const [typeSection, importSection, functionSection, exportSection] = [1, 2, 3, 7]

/**
 * Maps the name of each export → { parameters, result }, TypeScript types. Wasm's vector types, for which JavaScript has none, are `never`.
 */
export function wasmSignatures(bytes) {
  // Skips the magic number and the version.
  let offset = 8
  const number = () => {
    let value = 0
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[offset++]
      value += (byte & 127) * 2 ** shift
      if (byte < 128) return value
    }
  }
  const list = (read) => Array.from({ length: number() }, read)
  const text = () => {
    const size = number()
    return new TextDecoder().decode(bytes.subarray(offset, (offset += size)))
  }
  const valueType = () => kinds[bytes[offset++]] ?? 'never'
  const limits = () => {
    if (number() & 1) number()
    number()
  }
  const skipImport = [number, () => (offset++, limits()), limits, () => (offset += 2)]

  let types = []
  const functions = []
  const exported = new Map()
  const read = {
    [typeSection]: () => {
      types = list(() => {
        offset++ // 0x60, a function
        const parameters = list(valueType)
        const [result = 'void'] = list(valueType)
        return { parameters, result }
      })
    },
    [importSection]: () =>
      list(() => {
        text()
        text()
        const kind = bytes[offset++]
        const type = skipImport[kind]()
        if (kind === 0) functions.push(types[type])
      }),
    [functionSection]: () => functions.push(...list(() => types[number()])),
    [exportSection]: () =>
      list(() => {
        const name = text()
        const kind = bytes[offset++]
        const index = number()
        if (kind === 0) exported.set(name, functions[index])
      }),
  }
  while (offset < bytes.length) {
    const section = bytes[offset++]
    const end = number() + offset
    read[section]?.()
    offset = end
  }
  return exported
}
